#pragma once

#include <dbd/terrain/terrain.h>
#include <dbd/terrain/tin_surface.h>

#include <memory>
#include <string>
#include <vector>

#include "load_elevation.h"

namespace dbd {

/// A TIN and a raster of it.
struct TinGround {
  ElevationRaster raster;                 ///< in map coordinates
  std::shared_ptr<const TinSurface> tin;  ///< in W, whose origin is the raster's rounded centre
};

/// Reads the mesh or the points (triangulated after Delaunay) that `files.elevation` names and
/// samples the surface to a raster. Appends what is odd about it to `notes`.
/// Throws InputError that names the file and what is wrong with it.
TinGround LoadTin(const TerrainFiles& files, std::vector<std::string>* notes);

/// W's origin for a raster: its centre in whole metres.
Eigen::Vector2d OriginOf(const HeightMap::Grid& map_grid);

/// Projected coordinate system in metres that the user named, as WKT; empty for "".
/// Throws InputError.
std::string MetricCrs(const std::string& file, const std::string& crs);

}  // namespace dbd
