#pragma once

#include <dbd/core/executor.h>

#include <atomic>
#include <exception>
#include <vector>

namespace dbd {

/// The workers of one lock-step run. Every thread that calls `Work` with a worker number of its
/// own takes part until all rounds are over; any number of them, from one on, finishes the run.
class LockstepTeam {
 public:
  LockstepTeam(int workers, std::int64_t rounds, int items, const RoundFunction& work);

  void Work(int worker);

  /// Throws what a worker's function threw, if any did. Call when all have returned.
  void Rethrow() const;

 private:
  /// How many blocks of one worker's share have been claimed since the first round. A worker's
  /// share has the same number of blocks in every round, so that the count tells the round too.
  struct alignas(64) Claims {
    std::atomic<std::int64_t> count{0};
  };

  /// Claims the next block of `owner` in this round; -1: none is left.
  int Claim(int owner, std::int64_t round);
  /// Runs what can be claimed in this round; returns how many blocks.
  std::int64_t RunBlocks(int worker, std::int64_t round);
  void RunBlock(int worker, std::int64_t round, int block);
  /// Until the round is over, or a worker has failed.
  void AwaitEndOf(std::int64_t round) const;

  int workers_;
  int blocks_per_worker_;
  std::int64_t blocks_;  // per round
  std::int64_t rounds_;
  int items_;
  const RoundFunction& work_;
  std::vector<Claims> claims_;                         // by worker
  alignas(64) std::atomic<std::int64_t> finished_{0};  // blocks since the first round
  alignas(64) std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
};

}  // namespace dbd
