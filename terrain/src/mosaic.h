#pragma once

#include <gdal_priv.h>

#include <string>
#include <vector>

namespace dbd {

/// Several rasters of one coordinate system as one, at the finest of their resolutions; later ones
/// lie on top. Throws InputError when they do not fit together.
GDALDatasetUniquePtr OpenMosaic(const std::vector<std::string>& files);

}  // namespace dbd
