#pragma once

#include <dbd/terrain/terrain.h>

#include "load_elevation.h"

namespace dbd {

/// What of the surface model rises more than `threshold` [m] above the ground, as obstacles on the
/// ground's grid (bilinear). Throws InputError that names the file and what is wrong with it.
ObstacleMap LoadSurfaceModel(const std::string& file, double threshold,
                             const ElevationRaster& ground, const LocalFrame& frame);

}  // namespace dbd
