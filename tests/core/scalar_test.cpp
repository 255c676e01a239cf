#include "scalar.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

TEST(Scalar, FunctionsOfOneNumber) {
  EXPECT_EQ(Select(true, 1.0, 2.0), 1);
  EXPECT_EQ(Min(1.0, 2.0), 1);
  EXPECT_EQ(Max(1.0, 2.0), 2);
  EXPECT_EQ(Clamp(5.0, -1.0, 1.0), 1);
  EXPECT_EQ(Clamp(-5.0, -1.0, 1.0), -1);
  EXPECT_EQ(Clamp(0.5, -1.0, 1.0), 0.5);
  EXPECT_EQ(LaneTraits<double>::kLanes, 1);
}

}  // namespace
}  // namespace dbd
