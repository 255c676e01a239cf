#include <dbd/planner/candidate_curve.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

TEST(DensePoses, MeetsEveryWaypointAndStepsAtMostAMetre) {
  const std::vector<Pose2> waypoints{{0, 0, 0}, {30, 10, 1.5}, {10, 40, -3.0}};
  const std::vector<Pose2> poses = DensePoses(waypoints, 5);
  EXPECT_EQ(poses.front().x, 0);
  EXPECT_EQ(poses.back().y, 40);
  double nearest = 1e9;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    nearest = std::min(nearest, (poses[i].position() - waypoints[1].position()).norm());
    if (i == 0) continue;
    EXPECT_LE((poses[i].position() - poses[i - 1].position()).norm(), kPoseStep + 1e-9);
    // 1 m of a 5 m circle turns by 0.2 rad.
    EXPECT_LE(std::abs(WrapAngle(poses[i].heading - poses[i - 1].heading)), 0.2 + 1e-6);
  }
  EXPECT_EQ(nearest, 0);
  EXPECT_TRUE(DensePoses({}, 5).empty());
}

TEST(CurveCost, IsLengthTimesRateOnLevelGround) {
  const Terrain terrain = SurfaceTerrain(101, 101, 1.0, [](double, double) { return 0.0; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const double rate = layer.SecondsPerMetre(50, 50, 0);
  const Pose2 from{20, 50, 0};
  const Pose2 to{70, 50, 0};
  const double cost = CurveCost(layer, from, ShortestDubinsCurve(from, to, 5));
  EXPECT_NEAR(cost, 50 * rate, 1e-6);
  EXPECT_NEAR(PosesCost(layer, DensePoses({from, to}, 5)), cost, 1e-6);
}

TEST(CurveCost, IsTheSameUpToALimitAndNoLessBeyond) {
  const Terrain terrain = SurfaceTerrain(101, 101, 1.0, [](double x, double y) {
    return 0.1 * std::sin(0.3 * x) * std::cos(0.2 * y);
  });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const Pose2 from{20, 50, 0};
  const DubinsCurve curve = ShortestDubinsCurve(from, {60, 55, 0.5}, 5);
  const double cost = CurveCost(layer, from, curve);
  ASSERT_TRUE(std::isfinite(cost));
  for (const double share : {1.0, 1.001, 2.0}) {
    EXPECT_EQ(CurveCost(layer, from, curve, share * cost), cost);
  }
  for (const double share : {0.0, 0.01, 0.5, 0.999}) {
    EXPECT_GE(CurveCost(layer, from, curve, share * cost), cost);
  }
  EXPECT_TRUE(std::isinf(CurveCost(layer, from, curve, 0.5 * cost)));
}

TEST(CurveCost, IsInfiniteAcrossWater) {
  // Water from x = 13 to 15; the front wheels are about 2 m ahead of the path point.
  const Terrain terrain = DrawnTerrain(std::vector<std::string>(6, ".......~......"), 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const Pose2 from{4, 5, 0};
  EXPECT_TRUE(std::isinf(CurveCost(layer, from, ShortestDubinsCurve(from, {20, 5, 0}, 4))));
  EXPECT_FALSE(std::isinf(CurveCost(layer, from, ShortestDubinsCurve(from, {8, 5, 0}, 4))));
  EXPECT_FALSE(AllGo(layer, DensePoses({from, {20, 5, 0}}, 4)));
}

}  // namespace
}  // namespace dbd
