#pragma once

#include <cstddef>
#include <string>

#include "load_elevation.h"

class OGRSpatialReference;

namespace dbd {

/// A metre of this coordinate system is not a metre on the ground (within 2 %): geographic, in
/// feet, or stretched like Web Mercator. `grid` is in coordinates of `crs`.
bool NeedsWarp(const OGRSpatialReference& crs, const HeightMap::Grid& grid);

/// Resamples (cubic: bilinear would smooth the ground) to the UTM zone of the centre, polar
/// stereographic beyond UTM, at about the same resolution with square cells. Throws InputError with
/// `name`.
void WarpToUtm(const std::string& name, std::size_t bytes_per_cell, double memory_limit,
               ElevationRaster* raster);

}  // namespace dbd
