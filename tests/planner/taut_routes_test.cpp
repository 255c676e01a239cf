#include "taut_routes.h"

#include <dbd/planner/candidate_curve.h>
#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

RouteDraft Draft(const std::vector<Pose2>& waypoints, double cost) {
  return {"test", DensePoses(waypoints, 4), cost, {}};
}

PlanRequest Across() {
  PlanRequest request;
  request.start = {10, 50};
  request.goal = {90, 50};
  return request;
}

/// A rough band that the layer's cost avoids, and level ground round it.
Terrain RoughBand() {
  return SurfaceTerrain(101, 101, 1, [](double x, double y) {
    return std::abs(y - 50) < 8 && x > 30 && x < 70 ? 0.15 * std::sin(1.7 * x) : 0.0;
  });
}

double Length(const RouteDraft& draft) {
  return static_cast<double>(draft.poses.size() - 1) * kPoseStep;
}

TEST(TautRoutes, GoStraightWhereTheCostWouldGoRound) {
  const Terrain terrain = RoughBand();
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  const RouteDraft round = Draft({{10, 50, 0.6}, {50, 68, 0}, {90, 50, -0.6}}, 20);
  const auto taut = TautRoutes(layer, 4, Across(), {round}, 2, 1);
  ASSERT_EQ(taut.size(), 1u);
  EXPECT_LT(Length(taut[0]), 83);  // 80 m straight
  EXPECT_GT(Length(round), 85);
  EXPECT_EQ(taut[0].poses.front().position(), Across().start);
  EXPECT_EQ(taut[0].poses.back().position(), Across().goal);
  EXPECT_DOUBLE_EQ(taut[0].cost, PosesCost(layer, taut[0].poses));
}

TEST(TautRoutes, PullTheShortestOfThoseThatHold) {
  const Terrain terrain = RoughBand();
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  const RouteDraft longer = Draft({{10, 50, 1.2}, {50, 90, 0}, {90, 50, -1.2}}, 20);
  const RouteDraft shorter = Draft({{10, 50, 0.6}, {50, 68, 0}, {90, 50, -0.6}}, 25);
  const RouteDraft not_go =
      Draft({{10, 50, 0}, {90, 50, 0}}, std::numeric_limits<double>::infinity());
  EXPECT_EQ(TautRoutes(layer, 4, Across(), {longer, not_go}, 2, 1).size(), 1u);
  EXPECT_EQ(TautRoutes(layer, 4, Across(), {longer, shorter}, 2, 1).size(), 2u);
  EXPECT_TRUE(TautRoutes(layer, 4, Across(), {longer, shorter}, 0, 1).empty());
}

TEST(TautRoutes, StayOffNoGo) {
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
      },
      5.0);
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  PlanRequest request;
  request.start = {10, 10};
  request.goal = {85, 10};
  const RouteDraft round =
      Draft({{10, 10, 1.2}, {30, 30, 0.5}, {50, 33, 0}, {70, 25, -0.8}, {85, 10, -1.2}}, 30);
  for (const RouteDraft& taut : TautRoutes(layer, 4, request, {round}, 1, 1)) {
    EXPECT_TRUE(AllGo(layer, taut.poses));
  }
}

}  // namespace
}  // namespace dbd
