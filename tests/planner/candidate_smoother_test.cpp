#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/candidate_smoother.h>
#include <gtest/gtest.h>

#include <cmath>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

TEST(SmoothRoute, TakesOutWigglesAndKeepsTheEnds) {
  const Terrain terrain = SurfaceTerrain(101, 101, 1.0, [](double, double) { return 0.0; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const std::vector<Pose2> wiggly =
      DensePoses({{10, 50, 0}, {30, 60, 1}, {50, 40, -1}, {70, 60, 1}, {90, 50, 0}}, 4);
  const std::vector<Pose2> smooth = SmoothRoute(layer, 4, wiggly, SmoothingOptions{}, 1).poses;
  EXPECT_LT(PosesCost(layer, smooth), 0.9 * PosesCost(layer, wiggly));
  // 80 m straight is the least.
  EXPECT_GE(PosesCost(layer, smooth), 80 * layer.min_seconds_per_metre());
  EXPECT_EQ(smooth.front().position(), wiggly.front().position());
  EXPECT_EQ(smooth.back().position(), wiggly.back().position());
  EXPECT_EQ(smooth.front().heading, 0);
  EXPECT_EQ(smooth.back().heading, 0);
  EXPECT_TRUE(AllGo(layer, smooth));
}

TEST(SmoothRoute, KnowsTheCostsToTheLastBit) {
  const Terrain terrain = SurfaceTerrain(101, 101, 1.0, [](double x, double y) {
    return 0.1 * std::sin(0.3 * x) * std::cos(0.2 * y);
  });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const std::vector<Pose2> wiggly =
      DensePoses({{10, 50, 0}, {30, 60, 1}, {50, 40, -1}, {70, 60, 1}, {90, 50, 0}}, 4);
  SmoothingOptions options;
  options.free_start = options.free_goal = true;
  for (const int attempts : {0, 1, 5, 80}) {
    options.attempts = attempts;
    const SmoothedRoute route = SmoothRoute(layer, 4, wiggly, options, 1);
    EXPECT_EQ(route.former_cost, PosesCost(layer, wiggly));
    EXPECT_EQ(route.cost, PosesCost(layer, route.poses));
  }
  const SmoothedRoute two = SmoothRoute(layer, 4, {{10, 50, 0}, {11, 50, 0}}, options, 1);
  EXPECT_EQ(two.cost, PosesCost(layer, two.poses));
}

TEST(SmoothRoute, TurnsFreeEndsTowardsTheRoute) {
  const Terrain terrain = SurfaceTerrain(101, 101, 1.0, [](double, double) { return 0.0; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const std::vector<Pose2> poses = DensePoses({{20, 50, 3.1}, {80, 50, 3.1}}, 4);
  SmoothingOptions options;
  options.free_start = options.free_goal = true;
  const std::vector<Pose2> smooth = SmoothRoute(layer, 4, poses, options, 1).poses;
  EXPECT_NEAR(PosesCost(layer, smooth), 60 * layer.SecondsPerMetre(50, 50, 0), 0.05);
}

TEST(SmoothRoute, StaysOffNoGo) {
  const Terrain terrain = DrawnTerrain(
      {
          "....................",
          "....................",
          "....................",
          "....................",
          ".........~~.........",
          ".........~~.........",
          ".........~~.........",
          ".........~~.........",
          ".........~~.........",
          ".........~~.........",
      },
      4.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const std::vector<Pose2> round =
      DensePoses({{10, 8, 1.5}, {16, 28, 1.0}, {38, 32, 0}, {60, 26, -1.2}, {66, 8, -1.5}}, 4);
  ASSERT_TRUE(AllGo(layer, round));
  SmoothingOptions options;
  options.attempts = 300;
  const std::vector<Pose2> smooth = SmoothRoute(layer, 4, round, options, 1).poses;
  EXPECT_TRUE(AllGo(layer, smooth));
  EXPECT_LE(PosesCost(layer, smooth), PosesCost(layer, round));
}

}  // namespace
}  // namespace dbd
