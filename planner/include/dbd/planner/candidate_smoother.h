#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <cstdint>
#include <vector>

namespace dbd {

struct SmoothingOptions {
  int attempts = 80;
  double longest = 120.0;   ///< part of a route that one attempt may replace [m]
  bool free_start = false;  ///< the heading at the start may change
  bool free_goal = false;
};

/// Dense poses, and their `PosesCost` before and after they were smoothed [s].
struct SmoothedRoute {
  std::vector<Pose2> poses;
  double former_cost = 0;
  double cost = 0;
};

/// Replaces parts of a route of dense poses by single Dubins curves where those cost less: takes
/// out the loops and wiggles of sampled routes. The result is dense, never costs more, has the
/// same end places, and is the same for the same seed.
SmoothedRoute SmoothRoute(const TrafficabilityLayer& layer, double turning_radius,
                          std::vector<Pose2> poses, const SmoothingOptions& options,
                          std::uint64_t seed);

}  // namespace dbd
