#include <dbd/planner/body_executor.h>
#include <dbd/planner/thread_count.h>

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <chrono>

#include "cut_over.h"
#include "lockstep_team.h"

namespace dbd {

struct BodyExecutor::Impl {
  explicit Impl(const BodyExecutorOptions& given)
      : options(given), threads(ThreadCount(given.threads)), arena(threads) {}

  void RunShared(std::int64_t rounds, int items, const RoundFunction& work) {
    LockstepTeam team(std::min(threads, items), rounds, items, work);
    arena.execute([&] {
      tbb::task_group group;
      for (int worker = 1; worker < std::min(threads, items); ++worker) {
        group.run([&team, worker] { team.Work(worker); });
      }
      team.Work(0);
      group.wait();
    });
    team.Rethrow();
    shared_rounds += rounds;
  }

  void RunMeasured(std::int64_t rounds, int items, const RoundFunction& work);

  BodyExecutorOptions options;
  int threads;
  tbb::task_arena arena;
  CutOver cut_over;
  int last_items = 0;
  std::int64_t shared_rounds = 0;
  std::int64_t all_rounds = 0;
};

/// Rounds are handed on with their number counted from the run's beginning.
void BodyExecutor::Impl::RunMeasured(std::int64_t rounds, int items, const RoundFunction& work) {
  using Clock = std::chrono::steady_clock;
  for (std::int64_t done = 0; done < rounds;) {
    const CutOver::Plan plan = cut_over.Next(rounds - done);
    const RoundFunction later = [&work, done](int worker, std::int64_t round, int begin, int end) {
      work(worker, done + round, begin, end);
    };
    const Clock::time_point start = Clock::now();
    if (plan.parallel) {
      RunShared(plan.rounds, items, later);
    } else {
      SerialExecutor().Run(plan.rounds, items, later);
    }
    cut_over.Report(plan, std::chrono::duration<double>(Clock::now() - start).count());
    done += plan.rounds;
  }
}

BodyExecutor::BodyExecutor(const BodyExecutorOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
BodyExecutor::~BodyExecutor() = default;

int BodyExecutor::worker_count() const { return impl_->threads; }

void BodyExecutor::Run(std::int64_t rounds, int items, const RoundFunction& work) {
  Impl& s = *impl_;
  s.all_rounds += rounds;
  if (s.threads == 1 || items < std::max(2, s.options.least_items)) {
    SerialExecutor().Run(rounds, items, work);
  } else if (s.options.adapt) {
    if (items != s.last_items) s.cut_over = {};
    s.last_items = items;
    s.RunMeasured(rounds, items, work);
  } else {
    s.RunShared(rounds, items, work);
  }
}

double BodyExecutor::parallel_share() const {
  if (impl_->all_rounds == 0) return 0;
  return static_cast<double>(impl_->shared_rounds) / static_cast<double>(impl_->all_rounds);
}

}  // namespace dbd
