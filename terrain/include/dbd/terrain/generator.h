#pragma once

#include <cstdint>
#include <string>

namespace dbd {

/// A synthetic landscape: hills, a brook, soils and trees, the same for the same seed.
struct GeneratorOptions {
  int size = 400;             ///< cells in x and in y
  double cell_size = 1.0;     ///< [m]
  double relief = 30.0;       ///< highest minus lowest ground [m]
  double wavelength = 150.0;  ///< of the largest hills [m]
  std::uint64_t seed = 1;
  double tree_density = 15;  ///< trees per hectare
  bool walled_goal = false;  ///< digs a closed trench that no vehicle crosses round the map centre

  /// Throws InputError that names the field, its value and the rule.
  void Validate() const;
};

/// Files that a generated terrain consists of, and a drive across it.
struct GeneratedTerrain {
  std::string elevation;       ///< GeoTIFF, float32, UTM
  std::string materials;       ///< GeoTIFF, byte
  std::string material_table;  ///< JSON
  std::string obstacles;       ///< OctoMap .bt, in map coordinates relative to `obstacles_origin`
};

/// Writes dem.tif, materials.tif, materials.json and obstacles.bt into `directory`, which is
/// created. Throws InputError when that fails.
GeneratedTerrain GenerateTerrain(const GeneratorOptions& options, const std::string& directory);

}  // namespace dbd
