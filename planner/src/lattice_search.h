#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/roadmap.h>
#include <dbd/planner/trafficability.h>

#include <stop_token>
#include <vector>

namespace dbd {

struct LatticeOptions {
  int expansions = 150'000;  ///< poses whose successors are looked at, at most
  bool reversing = false;    ///< poses go on in reverse too, at kGearChangeCost per change
};

/// Looks for a way through places that random poses hardly ever hit: hybrid-state A* (D. Dolgov, S.
/// Thrun, M. Montemerlo, J. Diebel, "Path planning for autonomous vehicles in unknown
/// semi-structured environments", 2010). Poses are continuous; one is kept per cell and heading. A
/// pose goes on straight or along a tightest turn; near the goal a Dubins curve ends the search, or
/// a Reeds-Shepp curve where that costs less and the vehicle may reverse. The cost is the layer's,
/// the cost to go that of a vehicle that turns on the spot
/// (`CostToGoField`).
///
/// Within the region, cells and budget it finds a way where there is one; it is not the cheapest.
/// Waypoints from a start to a goal of the query, each joined to the next by the shortest Dubins
/// curve; empty when there is none. Throws StopRequested soon after `stop` was asked to.
std::vector<Pose2> SearchLattice(const TrafficabilityLayer& layer, double turning_radius,
                                 const RoadmapQuery& query, const LatticeOptions& options,
                                 const std::stop_token& stop = {});

}  // namespace dbd
