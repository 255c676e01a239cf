#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/planner/thread_count.h>
#include <tbb/task_arena.h>

#include <optional>

namespace dbd {

/// Where the parallel loops of a plan run: in an arena of their own, or in the caller's.
class WorkArena {
 public:
  /// `threads`: as in PlanOptions.
  explicit WorkArena(int threads)
      : threads_(threads == kCallersArena ? tbb::this_task_arena::max_concurrency()
                                          : ThreadCount(threads)) {
    if (threads != kCallersArena) own_.emplace(threads_);
  }

  int threads() const { return threads_; }

  template <class Work>
  void Execute(const Work& work) {
    if (own_) {
      own_->execute(work);
    } else {
      work();
    }
  }

 private:
  int threads_;
  std::optional<tbb::task_arena> own_;
};

}  // namespace dbd
