#pragma once

#include <dbd/terrain/material_map.h>

#include <cstdint>
#include <string>
#include <vector>

namespace dbd {

/// Burns the polygons of a vector file into `map_grid` (where cell centres lie inside; later ones
/// on top). `field` holds a class number or the name of a material in `table`; empty: the
/// attribute called class, code, material or name. Returns classes as `LoadClasses` does.
/// Throws InputError that names the file and what is wrong with it.
std::vector<std::int32_t> LoadPolygons(const std::string& file, const std::string& field,
                                       const MaterialTable& table, const HeightMap::Grid& map_grid,
                                       const std::string& map_wkt);

/// Polygons are told from rasters by the file's extension.
bool IsPolygonFile(const std::string& file);

}  // namespace dbd
