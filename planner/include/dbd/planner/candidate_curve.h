#pragma once

#include <dbd/core/path.h>
#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace dbd {

// A route on its way to becoming a candidate is a row of poses, each joined to the next by the
// shortest Dubins curve: far apart for what a planner returns, about `kPoseStep` apart when dense.
inline constexpr double kPoseStep = 1.0;  // [m]

/// What a change between forward and reverse costs [s]: to stop, to shift and to start again.
inline constexpr double kGearChangeCost = 4.0;

/// What a metre in reverse costs on top [s/m]: nobody backs a long way who could turn.
inline constexpr double kReverseCost = 1.0;

/// Layer cost [s] of a curve: each of its equal steps, at most `kPoseStep` long, at the rate of
/// its end, and no faster than `kReverseSpeed` plus kReverseCost in reverse; kGearChangeCost when
/// `from` was come to the other way. Infinite when a step ends on no-go. What costs more than
/// `limit` may be infinite too: nothing is added up once that shows. The pose at the start is not
/// looked at.
double CurveCost(const TrafficabilityLayer& layer, const Pose2& from, const DubinsCurve& curve,
                 double limit = std::numeric_limits<double>::infinity());

/// Layer cost [s] of the shortest curves from `from` to the first waypoint and on to the last.
double WaypointsCost(const TrafficabilityLayer& layer, Pose2 from,
                     const std::vector<Pose2>& waypoints, double turning_radius);

/// The poses at the steps of CurveCost, from the first waypoint to the last; each waypoint is met
/// exactly. Empty when `waypoints` is.
std::vector<Pose2> DensePoses(const std::vector<Pose2>& waypoints, double turning_radius);

/// Layer cost [s] from one dense pose to the next.
double StepCost(const TrafficabilityLayer& layer, const Pose2& from, const Pose2& to);

/// Layer cost [s] of dense poses, counted as by CurveCost.
double PosesCost(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses);

/// Every pose is go.
bool AllGo(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses);

/// Any pose but the first is come to in reverse.
bool Reverses(const std::vector<Pose2>& poses);

std::vector<Eigen::Vector2d> Positions(const std::vector<Pose2>& poses);

/// The path along dense poses that is driven from `start` to `goal`, which are where the first and
/// the last pose are.
Path PathAlong(const std::vector<Pose2>& poses, const Eigen::Vector2d& start,
               const Eigen::Vector2d& goal);

}  // namespace dbd
