#pragma once

#include <dbd/terrain/terrain.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace dbd {

/// A synthetic landscape: hills, a brook with fords, soils, trees and rocks, the same for the same
/// options.
struct GeneratorOptions {
  int size = 400;             ///< cells in x and in y, 64 to 8192
  double cell_size = 1.0;     ///< 0.1 to 100 [m]
  double relief = 30.0;       ///< highest minus lowest ground of the hills, 0 to 2000 [m]
  double wavelength = 150.0;  ///< of the largest hills, at least 8 cells [m]
  std::uint64_t seed = 1;
  double tree_density = 15;  ///< trees per hectare, 0 to 1000
  bool walled_goal = false;  ///< digs a closed trench that no vehicle crosses round the map centre;
                             ///< the map must be at least 100 m and 40 cells wide

  /// Throws InputError that names the field, its value and the rule.
  void Validate() const;
};

/// Files that a generated terrain consists of, and a drive across it.
struct GeneratedTerrain {
  std::string elevation;       ///< GeoTIFF, float32, EPSG:32633
  std::string materials;       ///< GeoTIFF, byte; codes as in the built-in table "basic"
  std::string material_table;  ///< JSON
  std::string obstacles;       ///< OctoMap .bt, x and y relative to `obstacles_origin`
  Eigen::Vector2d obstacles_origin = Eigen::Vector2d::Zero();  ///< map coordinates [m]
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< map coordinates of a free, flat place [m]
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();   ///< across the brook, or inside the trench [m]
};

/// Writes dem.tif, materials.tif, materials.json and obstacles.bt into `directory`, which is
/// created. Files with these names are replaced. Throws InputError when that fails; nothing is
/// left behind then.
GeneratedTerrain GenerateTerrain(const GeneratorOptions& options, const std::string& directory);

/// All of its files, to be loaded again.
TerrainFiles FilesOf(const GeneratedTerrain& generated);

}  // namespace dbd
