#include <dbd/core/units.h>
#include <dbd/terrain/obstacle_map.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr float kFree = std::numeric_limits<float>::infinity();

// 20 x 20 cells of 0.5 m, centres from 0.25; one obstacle 1.5 m above ground at 5.25, 5.25.
ObstacleMap MakeMap() {
  std::vector<float> lowest(400, kFree);
  lowest[10 * 20 + 10] = 1.5F;
  return ObstacleMap({20, 20, {0.25, 0.25}, {0.5, 0.5}}, lowest);
}

TEST(ObstacleMap, BlocksByHeight) {
  const ObstacleMap map = MakeMap();
  EXPECT_TRUE(map.Blocks(5.1, 5.4, 1.6));
  EXPECT_FALSE(map.Blocks(5.1, 5.4, 1.5));
  EXPECT_FALSE(map.Blocks(5.6, 5.4, 2.0));
  EXPECT_FALSE(map.Blocks(-100, 1e300, 2.0));
}

TEST(ObstacleMap, BlocksAStraightBox) {
  const ObstacleMap map = MakeMap();
  // The obstacle's square spans 5 to 5.5. A box 2 m by 1 m reaches it from 4.01 but not from 3.99.
  EXPECT_TRUE(map.BlocksBox({4.01, 5.25}, 0, {1, 0.5}, 2));
  EXPECT_FALSE(map.BlocksBox({3.99, 5.25}, 0, {1, 0.5}, 2));
  EXPECT_TRUE(map.BlocksBox({5.25, 4.01}, Degrees(90), {1, 0.5}, 2));
  EXPECT_FALSE(map.BlocksBox({5.25, 3.99}, Degrees(90), {1, 0.5}, 2));
}

TEST(ObstacleMap, BlocksATurnedBox) {
  const ObstacleMap map = MakeMap();
  // At 45 degrees the square's corner 5, 5 is sqrt(2) from 4, 4: a box with half length 1.45
  // reaches it along the diagonal, one with 1.38 does not.
  EXPECT_TRUE(map.BlocksBox({4, 4}, Degrees(45), {1.45, 0.3}, 2));
  EXPECT_FALSE(map.BlocksBox({4, 4}, Degrees(45), {1.38, 0.3}, 2));
  // Its bounding box holds the obstacle, the box itself passes beside it.
  EXPECT_FALSE(map.BlocksBox({5.25, 5.25 - 1.5}, Degrees(45), {3, 0.5}, 2));
}

TEST(ObstacleMap, AgreesWithSamplesOfTheBox) {
  const ObstacleMap map = MakeMap();
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d center(2 + 0.013 * k, 8 - 0.011 * k);
    const double heading = 0.1 * k;
    bool touched = false;
    for (double u = -1.2; u <= 1.2; u += 0.05) {
      for (double v = -0.6; v <= 0.6; v += 0.05) {
        touched |= map.Blocks(center.x() + std::cos(heading) * u - std::sin(heading) * v,
                              center.y() + std::sin(heading) * u + std::cos(heading) * v, 2);
      }
    }
    if (touched) {
      EXPECT_TRUE(map.BlocksBox(center, heading, {1.2, 0.6}, 2));
    } else {
      EXPECT_FALSE(map.BlocksBox(center, heading, {1.1, 0.5}, 2));
    }
  }
}

TEST(ObstacleMap, MayBeEmpty) {
  EXPECT_TRUE(ObstacleMap().empty());
  EXPECT_FALSE(ObstacleMap().BlocksBox({0, 0}, 0, {1, 1}, 100));
  EXPECT_EQ(ObstacleMap().BlockedShare(2), 0);
  EXPECT_DOUBLE_EQ(MakeMap().BlockedShare(2), 1.0 / 400);
}

}  // namespace
}  // namespace dbd
