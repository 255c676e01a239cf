#pragma once

#include <dbd/terrain/height_map.h>

#include <string>
#include <vector>

#include "raster_file.h"

namespace dbd {

/// Heights in a metric map coordinate system.
struct ElevationRaster {
  HeightMap::Grid grid;        ///< in map coordinates [m]
  std::vector<float> heights;  ///< rows x columns, row 0 south, relative to `base_height` [m], NaN
                               ///< where unknown
  double base_height = 0;      ///< [m]
  std::string map_wkt;         ///< empty when the file has no coordinate system
  std::string note;            ///< what whoever drives here should know; empty: nothing
  std::string source_wkt;      ///< the file's own system; differs from `map_wkt` after a warp
};

/// Reads an elevation raster that GDAL opens: scale, offset, unit, nodata and mask are applied.
/// What is geographic, not in metres, or not true to scale is warped (cubic, at about the same
/// resolution) to the UTM zone of its centre. Besides declared nodata, heights that no ground has
/// (-9999, beyond +-30 km, not finite) are unknown. Throws InputError that names the file and what
/// is wrong with it.
ElevationRaster LoadElevation(const RasterRequest& request);

/// Bytes that loading a raster of this size takes at its peak (twice where it must be warped).
std::size_t ElevationMemoryNeed(int columns, int rows);

}  // namespace dbd
