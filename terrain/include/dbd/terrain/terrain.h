#pragma once

#include <dbd/core/ground.h>
#include <dbd/terrain/height_map.h>
#include <dbd/terrain/local_frame.h>
#include <dbd/terrain/material_map.h>
#include <dbd/terrain/obstacle_map.h>

#include <functional>
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
  /// Any raster that GDAL opens; a mesh (.ply, .obj) or points (.xyz), driven on as a TIN; or an
  /// OctoMap (.bt, .ot) whose ground is extracted.
  std::string elevation;
  std::vector<std::string> more_elevation;  ///< joined with it; later ones lie on top
  int elevation_band = 0;                   ///< counted from 1; 0: the only one
  std::string crs;  ///< of the elevation, instead of what its file states: EPSG:n, WKT, PROJ
  UnknownGround unknown_ground = UnknownGround::kForbid;
  double fill_distance = 50;         ///< [m]
  MapPlacement elevation_placement;  ///< of a mesh, of points or of an OctoMap
  bool rasterise_tin = false;        ///< drive on a raster of it instead of its triangles
  double surface_cell_size = 0;      ///< of rasters made from TIN or OctoMap [m]; 0: by its density
  /// A raster that would need more than half of this memory [bytes] is cut to a window round the
  /// places; without places it is refused.
  double memory_limit = 4.0 * 1024 * 1024 * 1024;
  std::vector<Eigen::Vector2d> places;        ///< in the elevation's own coordinates
  std::vector<Eigen::Vector2d> wgs84_places;  ///< longitude and latitude [deg]
  std::string materials;       ///< class raster of integers, or polygons that OGR reads
  int materials_band = 0;      ///< counted from 1; 0: the only one
  std::string material_field;  ///< polygons' attribute: class number or material name; empty:
                               ///< the one called class, code, material or name
  std::string material_table;  ///< JSON file, or the name of a table that is built in
  std::optional<MoistureState> moisture;  ///< of the soils; none: as the table states them
  std::string obstacles;                  ///< OctoMap .bt or .ot
  MapPlacement obstacles_placement;       ///< of its x = y = 0
  UnknownSpace unknown_space = UnknownSpace::kFree;
  /// Heights of what stands on the ground (surface model), any raster; what rises more than
  /// `surface_threshold` [m] above `elevation` is an obstacle, beside those of `obstacles`.
  std::string surface_model;
  double surface_threshold = 0.5;
  std::string default_material = "firm-soil";  ///< where `materials` is empty
  /// Material of classes that the table lacks and of places without a class; empty: such classes
  /// are refused, such places are unknown.
  std::string unknown_material;
};

class TinSurface;

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
  /// True where `IsKnown` holds throughout a box; may be false where that takes long to find out.
  bool IsBoxKnown(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;
  std::optional<GroundGrid> Grid() const override;
  std::optional<GroundFacets> Facets() const override;
  std::optional<GroundSoils> SoilClasses() const override;

  const LocalFrame& frame() const { return frame_; }
  const HeightMap& heights() const { return heights_; }
  const MaterialMap& materials() const { return materials_; }
  const ObstacleMap& obstacles() const { return obstacles_; }

  /// Triangles that the wheels touch instead of `heights()`, which then is a raster of them for
  /// planning and pictures; null when there are none.
  const TinSurface* tin() const { return tin_.get(); }
  const std::shared_ptr<const TinSurface>& shared_tin() const { return tin_; }
  void set_tin(std::shared_ptr<const TinSurface> tin) { tin_ = std::move(tin); }

  /// What whoever drives here should know of how it was loaded, one sentence each.
  const std::vector<std::string>& notes() const { return notes_; }
  void set_notes(std::vector<std::string> notes) { notes_ = std::move(notes); }

 private:
  LocalFrame frame_;
  HeightMap heights_;
  MaterialMap materials_;
  ObstacleMap obstacles_;
  std::shared_ptr<const TinSurface> tin_;
  std::vector<std::string> notes_;
};

/// Called now and then while a terrain is loaded: what is done, how many rows of how many. What the
/// elevation needs of memory is in the first call's text, before anything is allocated.
using LoadProgress = std::function<void(const std::string& stage, int done, int total)>;

/// Reads the files and brings all of them into one local frame.
/// Throws InputError that names the file and what is wrong with it.
std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files,
                                           const LoadProgress& progress = {});

}  // namespace dbd
