#pragma once

#include <dbd/core/ground.h>
#include <dbd/terrain/height_map.h>

#include <cstdint>
#include <string>
#include <vector>

namespace dbd {

/// One row of a material table.
struct Material {
  int code = 0;             ///< the class number in the raster
  std::string name;
  SoilSample soil;
  double cone_index_spread = 0.2;  ///< coefficient of variation [-]
  bool passable = true;     ///< false: never driven on (water, buildings)
  std::string source;       ///< where the numbers come from, or "assumed"
};

/// Class number -> material, from JSON (schema dbd.materials/1).
class MaterialTable {
 public:
  /// `name_or_file`: a built-in table's name or a path. Throws InputError.
  static MaterialTable Load(const std::string& name_or_file);
  static std::vector<std::string> BuiltInNames();

  explicit MaterialTable(std::string name, std::vector<Material> materials);

  const std::string& name() const { return name_; }
  const std::vector<Material>& materials() const { return materials_; }
  const Material* FindCode(int code) const;
  const Material* FindName(const std::string& name) const;

 private:
  std::string name_;
  std::vector<Material> materials_;
};

/// Which material lies where: a class grid over W, nearest cell, or one material everywhere.
class MaterialMap {
 public:
  explicit MaterialMap(const Material& everywhere);

  /// `indices`: rows x columns, row 0 south, index into `table.materials()`; kNone = unknown.
  static constexpr std::uint8_t kNone = 255;
  MaterialMap(MaterialTable table, const HeightMap::Grid& grid, std::vector<std::uint8_t> indices);

  /// Material at a place; null outside the class raster or where the class is unknown.
  const Material* At(double x, double y) const;
  void Soils(int count, const double* x, const double* y, SoilSample* soil) const;

  const MaterialTable& table() const { return table_; }
  bool is_uniform() const { return indices_.empty(); }

 private:
  MaterialTable table_;
  HeightMap::Grid grid_;
  std::vector<std::uint8_t> indices_;
};

}  // namespace dbd
