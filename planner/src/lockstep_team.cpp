#include "lockstep_team.h"

#include <algorithm>
#include <thread>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace dbd {
namespace {

// A block is what an idle worker may take from a late one: a few, so that one pause of the
// operating system does not cost a whole share, and not many, as each costs an atomic operation.
constexpr int kBlocksPerWorker = 4;
constexpr int kSpins = 2000;  // some 30 us: several rounds of a scene that is worth sharing

void Pause() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#endif
}

}  // namespace

LockstepTeam::LockstepTeam(int workers, std::int64_t rounds, int items, const RoundFunction& work)
    : workers_(workers),
      blocks_per_worker_(std::clamp(items / workers, 1, kBlocksPerWorker)),
      blocks_(std::int64_t{workers_} * blocks_per_worker_),
      rounds_(rounds),
      items_(items),
      work_(work),
      claims_(static_cast<std::size_t>(workers)) {}

int LockstepTeam::Claim(int owner, std::int64_t round) {
  std::atomic<std::int64_t>& count = claims_[static_cast<std::size_t>(owner)].count;
  const std::int64_t first = round * blocks_per_worker_;
  std::int64_t claimed = count.load(std::memory_order_relaxed);
  while (claimed < first + blocks_per_worker_) {
    if (count.compare_exchange_weak(claimed, claimed + 1, std::memory_order_relaxed)) {
      return owner * blocks_per_worker_ + static_cast<int>(claimed - first);
    }
  }
  return -1;
}

void LockstepTeam::RunBlock(int worker, std::int64_t round, int block) {
  const auto bound = [this](std::int64_t b) { return static_cast<int>(b * items_ / blocks_); };
  try {
    work_(worker, round, bound(block), bound(block + 1));
  } catch (...) {
    if (!failed_.exchange(true)) failure_ = std::current_exception();
  }
}

std::int64_t LockstepTeam::RunBlocks(int worker, std::int64_t round) {
  std::int64_t done = 0;
  for (int i = 0; i < workers_; ++i) {
    const int owner = (worker + i) % workers_;
    for (int block = Claim(owner, round); block >= 0; block = Claim(owner, round)) {
      RunBlock(worker, round, block);
      ++done;
    }
  }
  return done;
}

void LockstepTeam::AwaitEndOf(std::int64_t round) const {
  const std::int64_t enough = (round + 1) * blocks_;
  for (int spins = 0; finished_.load(std::memory_order_acquire) < enough; ++spins) {
    if (failed_.load(std::memory_order_relaxed)) return;
    if (spins < kSpins) {
      Pause();
    } else {
      std::this_thread::yield();
    }
  }
}

/// Claims of a round happen only after the round before is finished: `finished_`, not the claims,
/// carries one round's results to the next.
void LockstepTeam::Work(int worker) {
  for (;;) {
    const std::int64_t round = finished_.load(std::memory_order_acquire) / blocks_;
    if (round >= rounds_ || failed_.load(std::memory_order_relaxed)) return;
    const std::int64_t done = RunBlocks(worker, round);
    if (done > 0) finished_.fetch_add(done, std::memory_order_acq_rel);
    AwaitEndOf(round);
  }
}

void LockstepTeam::Rethrow() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace dbd
