#pragma once

#include <octomap/OcTree.h>

#include <memory>
#include <vector>

#include "synthetic_landscape.h"

namespace dbd {

/// Trees (trunk and crown) in groves and a few rocks as voxels on the ground; none near the brook,
/// the trench or a place in `keep_free`. x and y from the map's south-west corner, z the height.
std::unique_ptr<octomap::OcTree> MakeObstacles(const GeneratorOptions& options,
                                               const SyntheticLandscape& landscape,
                                               const std::vector<Eigen::Vector2d>& keep_free);

}  // namespace dbd
