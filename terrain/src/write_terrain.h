#pragma once

#include <octomap/OcTree.h>

#include <string>

#include "synthetic_landscape.h"

namespace dbd {

/// Writes the files of a generated terrain under temporary names and renames them when all are
/// there. Throws InputError, and removes what it wrote, when that fails. Start and goal are left
/// to the caller.
GeneratedTerrain WriteTerrain(const SyntheticLandscape& landscape, octomap::OcTree& obstacles,
                              const std::string& directory);

}  // namespace dbd
