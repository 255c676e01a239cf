#pragma once

#include <dbd/planner/stop.h>
#include <tbb/parallel_for.h>

#include <stop_token>

namespace dbd {

/// Calls work(row) for all rows from `first` to before `last`, in parallel in the caller's task
/// arena. Rows are left out once `stop` was asked to; throws StopRequested then.
template <class Work>
void ForEachRow(int first, int last, const std::stop_token& stop, const Work& work) {
  tbb::parallel_for(first, last, [&](int row) {
    if (!stop.stop_requested()) work(row);
  });
  ThrowIfStopped(stop);
}

}  // namespace dbd
