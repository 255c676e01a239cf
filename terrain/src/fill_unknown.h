#pragma once

#include "load_elevation.h"

namespace dbd {

/// Interpolates unknown cells (inverse distance, GDAL's fill-nodata) from known ones at most
/// `distance` [m] away. Returns the share of all cells that were filled.
double FillUnknown(double distance, ElevationRaster* raster);

}  // namespace dbd
