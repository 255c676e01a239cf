#pragma once

#include <dbd/core/ground.h>
#include <dbd/terrain/height_map.h>
#include <dbd/terrain/local_frame.h>
#include <dbd/terrain/material_map.h>
#include <dbd/terrain/obstacle_map.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// Where a terrain comes from. Only `elevation` is required.
struct TerrainFiles {
  std::string elevation;       ///< any single-band raster that GDAL opens
  std::string materials;       ///< class raster, integer
  std::string material_table;  ///< JSON file, or the name of a table that is built in
  std::string obstacles;       ///< OctoMap .bt or .ot
  Eigen::Vector2d obstacles_origin = Eigen::Vector2d::Zero();  ///< map coordinates of its x = y = 0
  bool obstacles_in_map_coordinates = true;                    ///< false: obstacles_origin is used
  std::string default_material = "firm-soil";  ///< where there is no material raster
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

 private:
  LocalFrame frame_;
  HeightMap heights_;
  MaterialMap materials_;
  ObstacleMap obstacles_;
};

/// Reads the files and brings all of them into one local frame.
/// Throws InputError that names the file and what is wrong with it.
std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files);

}  // namespace dbd
