#pragma once

#include <cstdint>
#include <functional>

namespace dbd {

/// Work on items `begin` up to `end` in one round. `worker` numbers the scratch that it may use: no
/// two calls with the same worker run at the same time.
using RoundFunction = std::function<void(int worker, std::int64_t round, int begin, int end)>;

/// Runs lock-step computations. The library's core knows no threads: it hands its rounds to an
/// executor, whose host chooses how many threads there are.
///
/// The function must give the same result however the items of a round are divided into ranges and
/// whatever their order, so that every executor gives the same bits.
class LockstepExecutor {
 public:
  virtual ~LockstepExecutor() = default;

  /// Workers are numbered from 0 up to this.
  virtual int worker_count() const = 0;

  /// Calls `work` so that it covers items 0 up to `items` once in each of `rounds` rounds; a round
  /// begins when all of the round before has ended. Returns after the last. An exception of `work`
  /// is thrown again here; later rounds then do not take place.
  virtual void Run(std::int64_t rounds, int items, const RoundFunction& work) = 0;
};

/// Everything in the calling thread.
class SerialExecutor final : public LockstepExecutor {
 public:
  int worker_count() const override { return 1; }
  void Run(std::int64_t rounds, int items, const RoundFunction& work) override {
    for (std::int64_t round = 0; round < rounds; ++round) work(0, round, 0, items);
  }
};

}  // namespace dbd
