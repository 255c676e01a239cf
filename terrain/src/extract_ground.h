#pragma once

#include <dbd/terrain/terrain.h>

#include <string>
#include <vector>

#include "load_elevation.h"

namespace dbd {

/// Ground heights from the OctoMap that `files.elevation` names: in each cell the lowest occupied
/// voxel, unless it lies well below its surroundings (a reflection) or stands on them (trees,
/// walls: a progressive morphological filter after Zhang et al. 2003,
/// doi:10.1109/TGRS.2003.810682); then smoothed, because voxels make steps. Appends how it was made
/// to `notes`. Throws InputError that names the file and what is wrong with it.
ElevationRaster ExtractGround(const TerrainFiles& files, std::vector<std::string>* notes);

}  // namespace dbd
