#pragma once

#include <dbd/terrain/height_map.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "raster_file.h"

namespace dbd {

inline constexpr std::int32_t kNoClass = std::numeric_limits<std::int32_t>::min();

/// Reads a band of integers in any grid and coordinate system and resamples it (nearest
/// cell) to `map_grid`, which is in the coordinates of `map_wkt` (may be empty). A raster without
/// a coordinate system is taken to be in map coordinates.
/// Returns rows x columns class numbers, row 0 south; kNoClass where it has none.
/// Throws InputError that names the file and what is wrong with it.
std::vector<std::int32_t> LoadClasses(const RasterRequest& request, const HeightMap::Grid& map_grid,
                                      const std::string& map_wkt);

}  // namespace dbd
