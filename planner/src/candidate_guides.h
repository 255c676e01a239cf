#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// Go poses along a way of cells, with the way's direction and a little to either side of it: the
/// nodes by which a roadmap passes narrow places that random nodes miss.
std::vector<Pose2> GuidePoses(const TrafficabilityLayer& layer,
                              const std::vector<Eigen::Vector2d>& way, double turning_radius);

}  // namespace dbd
