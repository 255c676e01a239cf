#include <dbd/core/simulation.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/terrain/height_map.h>
#include <dbd/terrain/terrain.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dbd {
namespace {

/// Rolling ground of 60 m x 60 m, its south-west corner far from the origin.
Terrain RollingTerrain(double cell) {
  HeightMap::Grid grid;
  grid.columns = grid.rows = static_cast<int>(60 / cell);
  grid.first_center = {-130, 370};
  grid.cell_size = {cell, cell};
  std::vector<float> heights;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d p = grid.Center(column, row);
      heights.push_back(static_cast<float>(250 +
                                           0.4 * std::sin(0.5 * p.x()) * std::cos(0.4 * p.y()) +
                                           0.03 * std::sin(4 * p.x() + 3 * p.y())));
    }
  }
  Material firm;
  firm.name = "firm";
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()), HeightMap(grid, heights),
                 MaterialMap(firm), ObstacleMap());
}

TEST(WheelLanes, DriveOnARasterAsTheReferenceDoes) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  for (const double cell : {0.05, 1.0}) {
    const Terrain terrain = RollingTerrain(cell);
    Simulation reference(*vehicle, terrain), lanes(*vehicle, terrain, {.wheel_lanes = true});
    ASSERT_TRUE(lanes.wheel_lanes());
    for (Simulation* s : {&reference, &lanes}) {
      s->Place({-125, 400}, 0.2);
      for (int i = 0; i < 750; ++i) s->Advance({.steer = 0.05, .engine_torque = 25});
    }
    EXPECT_GT(lanes.Chassis().p_WB.x(), -120) << cell;
    EXPECT_LT((reference.Chassis().p_WB - lanes.Chassis().p_WB).norm(), 1e-9) << cell;
    EXPECT_NEAR(reference.drive_energy(), lanes.drive_energy(), 1e-6) << cell;
  }
}

}  // namespace
}  // namespace dbd
