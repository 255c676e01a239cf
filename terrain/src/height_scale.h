#pragma once

#include <gdal_priv.h>

#include <string>

namespace dbd {

/// meters = scale * stored value + offset.
struct HeightScale {
  double scale = 1;
  double offset = 0;
};

/// From the band's scale, offset and unit; without a unit that of the vertical coordinate system;
/// without both, metres. Throws InputError with `name` when they are no usable numbers.
HeightScale HeightScaleOf(const std::string& name, GDALDataset* dataset, int band_number);

}  // namespace dbd
