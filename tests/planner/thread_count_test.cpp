#include <dbd/planner/plan_types.h>
#include <dbd/planner/thread_count.h>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace dbd {
namespace {

TEST(ThreadCount, AsAskedButNoMoreThanAllowed) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 3);
  PlanOptions options;
  options.threads = 2;
  EXPECT_EQ(ThreadCount(options.threads), 2);
  options.threads = 64;
  EXPECT_EQ(ThreadCount(options.threads), 3);
}

TEST(ThreadCount, AllThereAreWhenNoneAreNamed) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 2);
  PlanOptions options;
  options.threads = 0;
  EXPECT_EQ(ThreadCount(options.threads), 2);
}

}  // namespace
}  // namespace dbd
