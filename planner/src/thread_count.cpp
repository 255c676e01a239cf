#include <dbd/planner/thread_count.h>

#include <tbb/global_control.h>

#include <algorithm>

namespace dbd {

int ThreadCount(const PlanOptions& options) {
  const auto most = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return options.threads > 0 ? std::min(options.threads, most) : most;
}

}  // namespace dbd
