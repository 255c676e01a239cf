#pragma once

#include <dbd/terrain/terrain.h>

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace dbd {

/// What a terrain is like, for people to read.
struct TerrainInfo {
  struct MaterialShare {
    std::string name;
    double share = 0;  ///< of the cells [-]
    bool passable = true;
  };

  int columns = 0;
  int rows = 0;
  Eigen::Vector2d cell_size = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d extent = Eigen::Vector2d::Zero();  ///< outer edges, east-west and north-south [m]
  Eigen::Vector2d map_min = Eigen::Vector2d::Zero();  ///< outer corner in map coordinates [m]
  Eigen::Vector2d map_max = Eigen::Vector2d::Zero();
  /// The same corners in the file's own coordinates (x = easting or longitude), which requests use.
  Eigen::Vector2d file_south_west = Eigen::Vector2d::Zero();
  Eigen::Vector2d file_north_east = Eigen::Vector2d::Zero();
  double lowest = 0;         ///< [m]
  double highest = 0;        ///< [m]
  double unknown_share = 0;  ///< cells without a height [-]

  /// Angle of steepest ascent of the known cells, from central differences [rad].
  double median_slope = 0;
  double slope_90_percent = 0;  ///< nine in ten cells are flatter
  double slope_99_percent = 0;
  double steepest_slope = 0;

  std::string crs_name;       ///< of the map coordinates; empty when there is none
  std::string file_crs_name;  ///< of the file's own coordinates; empty when there is none
  std::size_t memory_bytes = 0;
  std::vector<MaterialShare> materials;  ///< in the table's order, only those that occur
  double unknown_material_share = 0;     ///< [-]
  bool has_obstacles = false;
  double obstacle_cell_size = 0;  ///< [m]
  double obstacle_share = 0;      ///< obstacle cells lower than 2 m above the ground [-]
};

TerrainInfo DescribeTerrain(const Terrain& terrain);

}  // namespace dbd
