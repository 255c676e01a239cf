#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/planner/trafficability.h>

#include <cstdint>
#include <vector>

#include "candidate_pool.h"

namespace dbd {

/// The shortest of these finished routes, at most `count`, pulled taut over all that is go: routes
/// for where the layer's cost is wrong about the direct way. Those that would cut a corner of no-go
/// ground are left out. The same for the same seed.
std::vector<RouteDraft> TautRoutes(const TrafficabilityLayer& layer, double turning_radius,
                                   const PlanRequest& request,
                                   const std::vector<RouteDraft>& drafts, int count,
                                   std::uint64_t seed);

}  // namespace dbd
