#include "speed_limits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

TEST(CapsBesideObstacles, SlowWhereAPostIsNearAndNowhereElse) {
  std::vector<std::string> drawing(30, std::string(80, '.'));
  drawing[29 - 16][40] = '#';  // at x = 40, y = 16
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  const auto vehicle = TestVehicle();
  const double beside = 15.5 - vehicle->outline.half_width;  // the post's cell begins at 15.5
  const Path near_it({{5, beside - 0.25}, {75, beside - 0.25}});
  const std::vector<SpeedCap> caps = CapsBesideObstacles(terrain, *vehicle, near_it);
  ASSERT_FALSE(caps.empty());
  double slowest = 100;
  for (const SpeedCap& cap : caps) {
    EXPECT_GT(cap.from, 25);
    EXPECT_LT(cap.to, 45);
    slowest = std::min(slowest, cap.speed);
  }
  EXPECT_LE(slowest, 1.5);
  const Path off_it({{5, beside - 0.6}, {75, beside - 0.6}});
  for (const SpeedCap& cap : CapsBesideObstacles(terrain, *vehicle, off_it)) {
    EXPECT_GT(cap.speed, 1.5);
  }
  EXPECT_FALSE(CapsBesideObstacles(terrain, *vehicle, off_it).empty());
  const Path far_off({{5, 5}, {75, 5}});
  EXPECT_TRUE(CapsBesideObstacles(terrain, *vehicle, far_off).empty());
}

}  // namespace
}  // namespace dbd
