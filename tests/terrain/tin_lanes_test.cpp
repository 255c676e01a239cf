#include <dbd/core/simulation.h>
#include <dbd/core/simulation_lanes.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/terrain/terrain.h>
#include <dbd/terrain/tin_surface.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "support/lane_kinds.h"

namespace dbd {
namespace {

/// Rolling ground of 60 m x 60 m in triangles about `spacing` wide whose corners lie anyhow, far
/// from the origin, with a hole; below it a raster that is 0.1 m lower.
Terrain IrregularTin(double spacing) {
  const auto height = [](double x, double y) {
    return 250 + 0.4 * std::sin(0.5 * x) * std::cos(0.4 * y);
  };
  const int count = static_cast<int>(60 / spacing) + 1;
  std::mt19937 random(1);
  const auto noise = [&] { return 0.3 * spacing * (static_cast<double>(random()) / 4294967296.0); };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TinSurface::Triangle> triangles;
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const double x = -130 + column * spacing + noise(), y = 370 + row * spacing + noise();
      vertices.emplace_back(x, y, height(x, y));
      const bool hole = row == count / 2 + 1 && column == count / 4;
      if (row == 0 || column == 0 || hole) continue;
      const auto here = static_cast<std::uint32_t>(vertices.size() - 1);
      const auto below = here - static_cast<std::uint32_t>(count);
      triangles.push_back({below - 1, below, here});
      triangles.push_back({below - 1, here, here - 1});
    }
  }
  const HeightMap::Grid grid{61, 61, {-130, 370}, {1, 1}};
  std::vector<float> heights;
  for (int row = 0; row < 61; ++row) {
    for (int column = 0; column < 61; ++column) {
      const Eigen::Vector2d p = grid.Center(column, row);
      heights.push_back(static_cast<float>(height(p.x(), p.y()) - 0.1));
    }
  }
  Terrain terrain(LocalFrame("", Eigen::Vector2d::Zero()), HeightMap(grid, heights),
                  MaterialMap(Material()), ObstacleMap());
  terrain.set_tin(std::make_shared<const TinSurface>(vertices, triangles));
  return terrain;
}

const VehicleModel& Tm27() {
  static const auto vehicle = LoadVehicle("tomcar-tm27");
  return *vehicle;
}

/// 3 s straight east, with the left wheels over the hole.
constexpr DriverCommand kCommand{.engine_torque = 30};
const Eigen::Vector2d kStart{-119, 399.8};

TEST(TinLanes, WheelsDriveAsTheReferenceDoes) {
  for (const double spacing : {0.2, 0.6, 1.3}) {
    const Terrain terrain = IrregularTin(spacing);
    Simulation reference(Tm27(), terrain), lanes(Tm27(), terrain, {.wheel_lanes = true});
    ASSERT_TRUE(lanes.wheel_lanes());
    for (Simulation* s : {&reference, &lanes}) {
      s->Place(kStart, 0);
      for (int i = 0; i < 750; ++i) s->Advance(kCommand);
    }
    EXPECT_GT(reference.Chassis().p_WB.x(), kStart.x() + 3.5) << spacing;
    // The reference finds out with floats how far a seam goes, where two planes overlap.
    EXPECT_LT((reference.Chassis().p_WB - lanes.Chassis().p_WB).norm(), 1e-6) << spacing;
  }
}

/// Of one lane among `neighbours` others that start elsewhere.
std::uint64_t HashAmong(const Terrain& terrain, LaneKind kind, int lane, bool neighbours) {
  SimulationLanes lanes(Tm27(), terrain, kind);
  for (int i = 0; i < lanes.lanes(); ++i) {
    if (i == lane) {
      lanes.Place(i, kStart, 0);
    } else if (neighbours) {
      lanes.Place(i, kStart + Eigen::Vector2d(1.7 * i, 9 - 2 * i), 0.4 * i);
    }
  }
  const std::vector<DriverCommand> commands(static_cast<std::size_t>(lanes.lanes()), kCommand);
  for (int i = 0; i < 1000; ++i) lanes.Advance(commands);
  return lanes.StateHash(lane);
}

TEST(TinLanes, NeitherNeighboursNorWidthMatter) {
  const Terrain terrain = IrregularTin(1.3);
  const std::uint64_t alone = HashAmong(terrain, LaneKind::kFloat, 0, false);
  for (const LaneKind kind : KindsWithTheSameBits()) {
    EXPECT_EQ(HashAmong(terrain, kind, 0, true), alone) << LaneKindName(kind);
    EXPECT_EQ(HashAmong(terrain, kind, 3, true), alone) << LaneKindName(kind);
  }
}

TEST(TinLanes, FloatsAgreeWithTheReference) {
  const Terrain terrain = IrregularTin(1.3);
  Simulation reference(Tm27(), terrain);
  reference.Place(kStart, 0);
  SimulationLanes lanes(Tm27(), terrain, LaneKind::kFloat);
  lanes.Place(0, kStart, 0);
  const std::vector<DriverCommand> commands(static_cast<std::size_t>(lanes.lanes()), kCommand);
  while (!lanes.driving(0)) lanes.Advance(commands);
  double squares = 0;
  bool over_the_hole = false;
  for (int i = 0; i < 750; ++i) {
    lanes.Advance(commands);
    reference.Advance(kCommand);
    const Eigen::Vector3d front_left = reference.Wheel(0).p_WH;
    over_the_hole = over_the_hole || !terrain.IsKnown(front_left.x(), front_left.y());
    squares += std::pow(lanes.Chassis(0).p_WB.z() - reference.Chassis().p_WB.z(), 2);
  }
  EXPECT_TRUE(over_the_hole);
  EXPECT_LT(std::sqrt(squares / 750), 1e-4);
}

}  // namespace
}  // namespace dbd
