#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <vector>

namespace dbd {

// A route on its way to becoming a candidate is a row of poses, each joined to the next by the
// shortest Dubins curve: far apart for what a planner returns, about `kPoseStep` apart when dense.
inline constexpr double kPoseStep = 1.0;  // [m]

/// Layer cost [s] of a curve: each of its equal steps, at most `kPoseStep` long, at the rate of
/// its end. Infinite when a step ends on no-go. The pose at the start is not looked at.
double CurveCost(const TrafficabilityLayer& layer, const Pose2& from, const DubinsCurve& curve);

/// The poses at the steps of CurveCost, from the first waypoint to the last; each waypoint is met
/// exactly. Empty when `waypoints` is.
std::vector<Pose2> DensePoses(const std::vector<Pose2>& waypoints, double turning_radius);

/// Layer cost [s] of dense poses, counted as by CurveCost.
double PosesCost(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses);

/// Every pose is go.
bool AllGo(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses);

std::vector<Eigen::Vector2d> Positions(const std::vector<Pose2>& poses);

}  // namespace dbd
