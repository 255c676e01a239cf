#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dbd {

enum class OmplPlanner {
  kRrtConnect,  ///< the first route it meets: cheap, and different for every seed
  kAbitStar,    ///< improves its route until its iterations are used up
};

/// "rrt-connect", "abit-star"
const char* OmplPlannerName(OmplPlanner planner);

struct OmplQuery {
  double turning_radius = 1;                             ///< [m]
  std::vector<Pose2> starts;                             ///< any may be left
  std::vector<Pose2> goals;                              ///< any may be reached
  Eigen::Vector2d min_corner = Eigen::Vector2d::Zero();  ///< where is sampled [m, W]
  Eigen::Vector2d max_corner = Eigen::Vector2d::Zero();
  bool reversing = false;  ///< Reeds-Shepp curves instead of Dubins'; for kRrtConnect only
};

/// Waypoints of a route, to be joined by Dubins curves, some of them in reverse when asked for;
/// empty when none was found within `iterations` (the planner's own steps, counted: never a time)
/// or when the planner's route does not hold before the layer. The same for the same seed, whatever
/// else runs at the same time. Throws StopRequested soon after `stop` was asked to.
std::vector<Pose2> SolveWithOmpl(OmplPlanner planner, const TrafficabilityLayer& layer,
                                 const OmplQuery& query, std::uint64_t seed, int iterations,
                                 const std::stop_token& stop = {});

/// Keeps OMPL from printing while at least one of these lives, then gives the process its output
/// handler back.
class OmplSilence {
 public:
  OmplSilence();
  ~OmplSilence();
  OmplSilence(const OmplSilence&) = delete;
  OmplSilence& operator=(const OmplSilence&) = delete;
};

}  // namespace dbd
