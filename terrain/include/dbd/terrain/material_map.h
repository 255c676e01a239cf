#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/soil_strength.h>
#include <dbd/terrain/height_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// One row of a material table.
struct Material {
  int code = 0;  ///< the class number in the raster
  std::string name;
  SoilSample soil;
  double cone_index_spread = 0.2;  ///< coefficient of variation [-]
  bool passable = true;            ///< false: never driven on (water, buildings)
  std::optional<UscsClass> uscs;   ///< its strength follows the moisture as this soil's does
  std::string source;              ///< where the numbers come from, or "assumed"
};

/// Class number -> material, from JSON (schema dbd.materials/1):
///
///     {"schema": "dbd.materials/1", "name": "basic", "materials": [
///       {"code": 3, "name": "gravel", "cone_index_kpa": 2000, "friction_limit": 0.8,
///        "cone_index_spread": 0.2, "passable": true, "source": "assumed"}]}
///
/// `code`, `name` and `cone_index_kpa` must be there; the others default to Material's and
/// SoilSample's values, `source` to "assumed". "traction_model" is brixius (default), wismer_luth
/// or bekker. Plate and shear constants, which bekker needs, are an object "plate":
///
///     "plate": {"n": 1.1, "kc_kn": 0.99, "kphi_kn": 1528.43, "cohesion_kpa": 1.04,
///               "friction_angle_deg": 28, "shear_deformation": 0.02}
///
/// "uscs" is the soil's class, for `InState`: "CL".
///
/// (kc in kN/m^(n+1), kphi in kN/m^(n+2), shear_deformation in m). With them the cone index may be
/// left out: it then follows from `MeanConeIndexFromBekker`.
class MaterialTable {
 public:
  /// `name_or_file`: a built-in table's name or a path. Throws InputError.
  static MaterialTable Load(const std::string& name_or_file);
  static std::vector<std::string> BuiltInNames();

  /// Throws InputError when a code or a name is there twice, or a value is out of range:
  /// 1 to 255 materials, cone index 0 (exclusive) to 20 MPa, friction limit 0 (exclusive) to 1.5,
  /// spread 0 to 1, code not negative.
  explicit MaterialTable(std::string name, std::vector<Material> materials);

  const std::string& name() const { return name_; }
  const std::vector<Material>& materials() const { return materials_; }
  const Material* FindCode(int code) const;
  const Material* FindName(const std::string& name) const;
  /// Throws InputError that names the nearest material.
  const Material& GetName(const std::string& name) const;

  /// The table as it is when the soils are dry or wet; its own numbers are those of moist soils.
  /// Cone indices of materials with a class are multiplied with `MoistureFactor`, up to the 300 psi
  /// that the relation knows or the table's own number. Throws InputError when none has a class.
  MaterialTable InState(MoistureState state) const;

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

  /// The same classes at the same places with other properties: as many materials as in the table.
  MaterialMap WithMaterials(std::vector<Material> materials) const;

  /// Material at a place; null outside the class raster or where the class is unknown.
  const Material* At(double x, double y) const;

  /// Where the material is unknown: the softest passable soil of the table.
  void Soils(int count, const double* x, const double* y, SoilSample* soil) const;

  /// The same as plain data, valid as long as this map stays where it is.
  GroundSoils View() const;

  /// Share of the cells of the material at this index of the table; kNone: of unknown cells.
  double Share(std::uint8_t index) const;

  const MaterialTable& table() const { return table_; }
  bool is_uniform() const { return indices_.empty(); }
  std::size_t memory_bytes() const { return indices_.size(); }

 private:
  std::uint8_t IndexAt(double x, double y) const;

  MaterialTable table_;
  HeightMap::Grid grid_;
  CellGrid cells_;  // of the same grid
  std::vector<std::uint8_t> indices_;
  std::array<SoilSample, 256> soils_;  // by index, so that a look-up has no branch
};

}  // namespace dbd
