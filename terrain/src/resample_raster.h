#pragma once

#include <gdal_priv.h>

#include <string>

#include "raster_file.h"

namespace dbd {

/// How one raster is brought to the grid of another.
struct Resampling {
  std::string method = "near";  ///< GDAL's name: near, bilinear, ...
  std::string data_type;        ///< GDAL's name of the result's type
  std::string nodata;           ///< value where the source has nothing
};

/// One band on `map_grid`, north row first, in coordinates of `map_wkt` (may be empty; a raster
/// without a coordinate system is taken to be in map coordinates). Throws InputError.
GDALDatasetUniquePtr ResampleTo(const RasterFile& file, const HeightMap::Grid& map_grid,
                                const std::string& map_wkt, const Resampling& resampling);

}  // namespace dbd
