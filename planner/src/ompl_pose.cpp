#include "ompl_pose.h"

#include <numbers>

namespace dbd {

namespace ob = ompl::base;

void SetPose(const Pose2& pose, ob::State* state) {
  auto* se2 = state->as<ob::SE2StateSpace::StateType>();
  const double yaw = WrapAngle(pose.heading);
  se2->setXY(pose.x, pose.y);
  se2->setYaw(yaw < std::numbers::pi ? yaw : -std::numbers::pi);
}

ob::RealVectorBounds Rectangle(const Eigen::Vector2d& min_corner,
                               const Eigen::Vector2d& max_corner) {
  ob::RealVectorBounds bounds(2);
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, min_corner[i]);
    bounds.setHigh(i, max_corner[i]);
  }
  return bounds;
}

}  // namespace dbd
