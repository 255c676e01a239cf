#include <dbd/planner/ompl_random.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

TEST(OmplRandom, HookIsLive) { EXPECT_TRUE(OmplSeedsAreOurs()); }

TEST(OmplRandom, HookIsLiveWithinScopesAndAfterThem) {
  {
    const OmplSeedScope outer(1);
    EXPECT_TRUE(OmplSeedsAreOurs());
  }
  EXPECT_TRUE(OmplSeedsAreOurs());
}

}  // namespace
}  // namespace dbd
