#include <dbd/planner/thread_count.h>

#include <tbb/global_control.h>

#include <algorithm>

namespace dbd {

int ThreadCount(int asked) {
  const auto most = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return asked > 0 ? std::min(asked, most) : most;
}

}  // namespace dbd
