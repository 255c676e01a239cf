#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/polyline_separation.h>
#include <dbd/planner/roadmap.h>
#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

RoadmapQuery Query(const TrafficabilityLayer& layer, const Pose2& start, const Pose2& goal) {
  RoadmapQuery query;
  query.starts = {start};
  query.goals = {goal};
  query.min_corner = layer.min_corner();
  query.max_corner = layer.max_corner();
  return query;
}

TEST(Roadmap, OnOpenGroundItsFirstRouteIsTheDirectCurve) {
  const Terrain terrain = SurfaceTerrain(201, 101, 1.0, [](double, double) { return 0.0; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  RoadmapOptions options;
  options.nodes = 300;
  const Roadmap roadmap(layer, 4, Query(layer, {20, 50, 0}, {180, 50, 0}), options);
  const std::vector<Pose2> route = roadmap.FindRoute();
  ASSERT_EQ(route.size(), 2u);
  EXPECT_EQ(route.front().x, 20);
  EXPECT_EQ(route.back().x, 180);
}

TEST(Roadmap, PenaltiesLeadElsewhere) {
  const Terrain terrain = SurfaceTerrain(201, 101, 1.0, [](double, double) { return 0.0; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  Roadmap roadmap(layer, 4, Query(layer, {20, 50, 0}, {180, 50, 0}), RoadmapOptions{});
  const auto first = Positions(DensePoses(roadmap.FindRoute(), 4));
  roadmap.Penalize(first, 20, 3);
  const auto second = Positions(DensePoses(roadmap.FindRoute(), 4));
  EXPECT_GT(Separation(first, second), 5);
  roadmap.ClearPenalties();
  EXPECT_EQ(Separation(first, Positions(DensePoses(roadmap.FindRoute(), 4))), 0);
}

TEST(Roadmap, EveryRouteIsGoWhenDrivenForward) {
  const Terrain terrain = SurfaceTerrain(
      201, 201, 1.0, [](double x, double y) { return 9 * std::sin(x / 17) * std::sin(y / 23); });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  Roadmap roadmap(layer, 4, Query(layer, {20, 20, 0.5}, {180, 170, 0.5}), RoadmapOptions{});
  for (int i = 0; i < 5; ++i) {
    const std::vector<Pose2> poses = DensePoses(roadmap.FindRoute(), 4);
    ASSERT_FALSE(poses.empty());
    EXPECT_TRUE(AllGo(layer, poses));
    roadmap.Penalize(Positions(poses), 20, 1);
  }
}

TEST(Roadmap, FindsNothingAcrossAClosedBand) {
  std::vector<std::string> drawing(30, std::string(60, '.'));
  for (std::string& row : drawing) row.replace(28, 4, "~~~~");
  const Terrain terrain = DrawnTerrain(drawing, 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  RoadmapOptions options;
  options.nodes = 500;
  const Roadmap roadmap(layer, 4, Query(layer, {20, 30, 0}, {100, 30, 0}), options);
  EXPECT_GT(roadmap.edge_count(), 500);
  EXPECT_TRUE(roadmap.FindRoute().empty());
}

}  // namespace
}  // namespace dbd
