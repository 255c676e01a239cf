#pragma once

#include <dbd/planner/dubins.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <Eigen/Core>

namespace dbd {

// Poses as states of OMPL's SE(2) and of the spaces derived from it.

inline Pose2 ToPose(const ompl::base::State* state) {
  const auto* se2 = state->as<ompl::base::SE2StateSpace::StateType>();
  return {se2->getX(), se2->getY(), se2->getYaw()};
}

/// A heading due west becomes -pi: OMPL's interval is [-pi, pi), and a start or goal outside of it
/// is never used.
void SetPose(const Pose2& pose, ompl::base::State* state);

ompl::base::RealVectorBounds Rectangle(const Eigen::Vector2d& min_corner,
                                       const Eigen::Vector2d& max_corner);

}  // namespace dbd
