#pragma once

#include <dbd/core/executor.h>

#include <memory>

namespace dbd {

struct BodyExecutorOptions {
  int threads = 0;  ///< 0: all that the process may have
  /// Fewer items are always done in the calling thread.
  int least_items = 4;
  /// Measure now and then whether one thread would be faster, as it is where other programs use
  /// the processors; false: always share, for tests and benchmarks.
  bool adapt = true;
};

/// Lock-step work over TBB threads. Each worker owns a fixed share of the items, so that their
/// state stays in its cache, and takes from others' shares when it is done: where TBB grants fewer
/// threads than asked, even none, those that run do all. One TBB task per worker and run, not per
/// round; between rounds workers spin for some microseconds, then yield.
///
/// One run at a time.
class BodyExecutor final : public LockstepExecutor {
 public:
  explicit BodyExecutor(const BodyExecutorOptions& options = {});
  ~BodyExecutor() override;

  int worker_count() const override;
  void Run(std::int64_t rounds, int items, const RoundFunction& work) override;

  /// Share of all rounds so far that were shared among threads, for reports.
  double parallel_share() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dbd
