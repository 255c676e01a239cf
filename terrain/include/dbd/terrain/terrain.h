#pragma once

#include <dbd/core/ground.h>
#include <dbd/terrain/height_map.h>
#include <dbd/terrain/local_frame.h>
#include <dbd/terrain/material_map.h>
#include <dbd/terrain/obstacle_map.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dbd {

/// What to do where the elevation is unknown.
enum class UnknownGround {
  kForbid,  ///< never driven on
  kFill,    ///< interpolated from around, up to `TerrainFiles::fill_distance` away
};

/// Where a terrain comes from. Only `elevation` is required.
struct TerrainFiles {
  std::string elevation;                    ///< any raster that GDAL opens
  std::vector<std::string> more_elevation;  ///< joined with it; later ones lie on top
  int elevation_band = 0;                   ///< counted from 1; 0: the only one
  std::string crs;  ///< of the elevation, instead of what its file states: EPSG:n, WKT, PROJ
  UnknownGround unknown_ground = UnknownGround::kForbid;
  double fill_distance = 50;   ///< [m]
  std::string materials;       ///< class raster of integers, or polygons that OGR reads
  int materials_band = 0;      ///< counted from 1; 0: the only one
  std::string material_field;  ///< polygons' attribute: class number or material name; empty:
                               ///< the one called class, code, material or name
  std::string material_table;  ///< JSON file, or the name of a table that is built in
  std::string obstacles;       ///< OctoMap .bt or .ot
  Eigen::Vector2d obstacles_origin = Eigen::Vector2d::Zero();  ///< map coordinates of its x = y = 0
  bool obstacles_in_map_coordinates = true;                    ///< false: obstacles_origin is used
  std::string default_material = "firm-soil";                  ///< where `materials` is empty
  /// Material of classes that the table lacks and of places without a class; empty: such classes
  /// are refused, such places are unknown.
  std::string unknown_material;
};

/// The ground with everything on it: surface, soil, obstacles and where it lies on Earth.
/// Immutable after loading, shared by all threads.
class Terrain final : public Ground {
 public:
  Terrain(LocalFrame frame, HeightMap heights, MaterialMap materials, ObstacleMap obstacles);

  void Heights(int count, const double* x, const double* y, double* z) const override;
  void Soils(int count, const double* x, const double* y, SoilSample* soil) const override;
  void HighestWithin(double radius, int count, const double* x, const double* y,
                     double* z) const override;
  bool IsKnown(double x, double y) const override;

  const LocalFrame& frame() const { return frame_; }
  const HeightMap& heights() const { return heights_; }
  const MaterialMap& materials() const { return materials_; }
  const ObstacleMap& obstacles() const { return obstacles_; }

  /// What whoever drives here should know of how it was loaded, one sentence each.
  const std::vector<std::string>& notes() const { return notes_; }
  void set_notes(std::vector<std::string> notes) { notes_ = std::move(notes); }

 private:
  LocalFrame frame_;
  HeightMap heights_;
  MaterialMap materials_;
  ObstacleMap obstacles_;
  std::vector<std::string> notes_;
};

/// Reads the files and brings all of them into one local frame.
/// Throws InputError that names the file and what is wrong with it.
std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files);

}  // namespace dbd
