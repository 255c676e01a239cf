#include <dbd/planner/candidate_flood.h>
#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

// 2 m cells; water all round a field in the middle.
const std::vector<std::string> kMoat = {
    "....................", "....................", "....................", "....................",
    "......~~~~~~~~......", "......~~~~~~~~......", "......~~....~~......", "......~~....~~......",
    "......~~....~~......", "......~~....~~......", "......~~....~~......", "......~~....~~......",
    "......~~~~~~~~......", "......~~~~~~~~......", "....................", "....................",
    "....................", "....................",
};

TEST(CellFlood, StopsAtWater) {
  const Terrain terrain = DrawnTerrain(kMoat, 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const CellFlood outside(layer, {4, 17}, FloodDirection::kFrom);
  EXPECT_TRUE(outside.Reaches({34, 17}));
  EXPECT_FALSE(outside.Reaches({19, 17}));
  EXPECT_TRUE(outside.WayTo({19, 17}).empty());
}

TEST(CellFlood, WayLeadsFromTheOriginOverGoCells) {
  const Terrain terrain = DrawnTerrain(kMoat, 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const CellFlood flood(layer, {4, 17}, FloodDirection::kFrom);
  const std::vector<Eigen::Vector2d> way = flood.WayTo({34, 17});
  ASSERT_FALSE(way.empty());
  EXPECT_LE((way.front() - Eigen::Vector2d(4, 17)).norm(), layer.resolution());
  EXPECT_LE((way.back() - Eigen::Vector2d(34, 17)).norm(), layer.resolution());
  for (std::size_t i = 1; i < way.size(); ++i) {
    EXPECT_LE((way[i] - way[i - 1]).norm(), 1.5 * layer.resolution());
    EXPECT_TRUE(layer.EvaluateAnyHeading(way[i].x(), way[i].y()).go());
  }
}

TEST(CellFlood, BarrierIsTheWaterOnTheStraightLine) {
  const Terrain terrain = DrawnTerrain(kMoat, 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const CellFlood inside(layer, {19, 17}, FloodDirection::kTo);
  const CellFlood::Barrier barrier = inside.BarrierTowards({3, 17});
  EXPECT_EQ(barrier.reason, NoGoReason::kImpassableMaterial);
  // The western arm of the water is x = 11 ... 15.
  EXPECT_NEAR(barrier.where.x(), 14.5, 2.5);
  EXPECT_NEAR(barrier.where.y(), 17, 1.0);
}

TEST(CellFlood, TreesOnTheLineAreNoBarrier) {
  // A brook of one cell from west to east; trees on the way to it.
  std::vector<std::string> rows(20, std::string(20, '.'));
  rows[4] = std::string(20, '~');
  rows[9][9] = rows[12][9] = rows[12][10] = rows[14][9] = '#';
  const Terrain terrain = DrawnTerrain(rows, 2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const CellFlood south(layer, {19, 3}, FloodDirection::kTo);
  ASSERT_FALSE(south.Reaches({19, 35}));
  const CellFlood::Barrier barrier = south.BarrierTowards({19, 35});
  EXPECT_EQ(barrier.reason, NoGoReason::kImpassableMaterial);
  EXPECT_NEAR(barrier.where.y(), 30, 4.0);
}

TEST(CellFlood, KnowsThatASteepBankIsOneWay) {
  // Mud-soft ground rising 25 deg to the east: down to the west only.
  const double grade = std::tan(25 * 3.14159265 / 180);
  const Terrain terrain = SurfaceTerrain(
      61, 61, 1.0, [grade](double x, double) { return grade * x; }, 1.6e5);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  ASSERT_EQ(layer.Evaluate(30, 30, 0).reason, NoGoReason::kTraction);
  EXPECT_TRUE(CellFlood(layer, {50, 30}, FloodDirection::kFrom).Reaches({10, 30}));
  EXPECT_FALSE(CellFlood(layer, {10, 30}, FloodDirection::kFrom).Reaches({50, 30}));
  EXPECT_TRUE(CellFlood(layer, {10, 30}, FloodDirection::kTo).Reaches({50, 30}));
}

}  // namespace
}  // namespace dbd
