#pragma once

#include <dbd/terrain/terrain.h>

#include "load_elevation.h"

namespace dbd {

/// The class raster or polygons and the table that `files` names, on the grid of the elevation.
/// Appends to `notes` what share of the ground got `files.unknown_material`.
/// Throws InputError that names the classes that the table lacks.
MaterialMap LoadMaterials(const TerrainFiles& files, const ElevationRaster& elevation,
                          const LocalFrame& frame, std::vector<std::string>* notes);

}  // namespace dbd
