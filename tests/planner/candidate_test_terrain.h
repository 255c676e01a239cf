#pragma once

#include <dbd/core/vehicle_database.h>
#include <dbd/planner/trafficability.h>
#include <dbd/terrain/terrain.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace dbd {

using HeightFunction = std::function<double(double x, double y)>;

inline HeightMap::Grid TestGrid(int columns, int rows, double cell) {
  HeightMap::Grid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.first_center = Eigen::Vector2d::Zero();
  grid.cell_size = Eigen::Vector2d(cell, cell);
  return grid;
}

inline Material TestMaterial(const char* name, double cone_index, bool passable = true) {
  Material material;
  material.name = name;
  material.soil.cone_index = cone_index;
  material.passable = passable;
  return material;
}

/// Firm ground whose height is a function of the place, south-west corner at W's origin.
inline Terrain SurfaceTerrain(int columns, int rows, double cell, const HeightFunction& height,
                              double cone_index = 1.8e6) {
  std::vector<float> heights;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      heights.push_back(static_cast<float>(height(column * cell, row * cell)));
    }
  }
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()),
                 HeightMap(TestGrid(columns, rows, cell), heights),
                 MaterialMap(TestMaterial("ground", cone_index)), ObstacleMap());
}

/// A terrain drawn as text, north row first: '.' level ground, '#' a post taller than any vehicle,
/// '~' water, '?' unknown, 'v' 4 m below, 'm' soft mud.
inline Terrain DrawnTerrain(const std::vector<std::string>& drawing, double cell) {
  const int rows = static_cast<int>(drawing.size());
  const int columns = static_cast<int>(drawing.front().size());
  std::vector<float> heights;
  std::vector<std::uint8_t> materials;
  std::vector<float> obstacles;
  for (int row = 0; row < rows; ++row) {
    for (const char mark : drawing[rows - 1 - row]) {
      heights.push_back(mark == '?'   ? std::numeric_limits<float>::quiet_NaN()
                        : mark == 'v' ? -4.0f
                                      : 0.0f);
      materials.push_back(mark == '~' ? 1 : mark == 'm' ? 2 : 0);
      obstacles.push_back(mark == '#' ? 0.5f : std::numeric_limits<float>::infinity());
    }
  }
  const HeightMap::Grid grid = TestGrid(columns, rows, cell);
  Material mud = TestMaterial("mud", 3e4);
  Material water = TestMaterial("water", 1e5, false);
  water.code = 1;
  mud.code = 2;
  const MaterialTable table("drawn", {TestMaterial("ground", 1.8e6), water, mud});
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()), HeightMap(grid, heights),
                 MaterialMap(table, grid, materials), ObstacleMap(grid, obstacles));
}

inline std::shared_ptr<const VehicleModel> TestVehicle() { return LoadVehicle("tomcar-tm27"); }

/// The layer's verdict with the vehicle's middle, not its path point, at a place.
inline NoGoReason ReasonAtMiddle(const TrafficabilityLayer& layer, double x, double y,
                                 double heading) {
  const auto vehicle = TestVehicle();
  const double ahead = vehicle->middle_x() - vehicle->path_point_x();
  return layer.Evaluate(x - ahead * std::cos(heading), y - ahead * std::sin(heading), heading)
      .reason;
}

}  // namespace dbd
