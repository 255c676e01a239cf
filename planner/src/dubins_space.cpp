#include "dubins_space.h"

namespace dbd {

namespace ob = ompl::base;

DubinsSpace::DubinsSpace(double turning_radius, const Eigen::Vector2d& min_corner,
                         const Eigen::Vector2d& max_corner)
    : ob::DubinsStateSpace(turning_radius) {
  ob::RealVectorBounds bounds(2);
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, min_corner[i]);
    bounds.setHigh(i, max_corner[i]);
  }
  setBounds(bounds);
}

Pose2 DubinsSpace::ToPose(const ob::State* state) {
  const auto* se2 = state->as<StateType>();
  return {se2->getX(), se2->getY(), se2->getYaw()};
}

void DubinsSpace::SetPose(const Pose2& pose, ob::State* state) {
  auto* se2 = state->as<StateType>();
  se2->setXY(pose.x, pose.y);
  se2->setYaw(WrapAngle(pose.heading));
}

DubinsCurve DubinsSpace::Curve(const ob::State* from, const ob::State* to) const {
  return ShortestDubinsCurve(ToPose(from), ToPose(to), rho_);
}

double DubinsSpace::distance(const ob::State* from, const ob::State* to) const {
  return Curve(from, to).length();
}

void DubinsSpace::interpolate(const ob::State* from, const ob::State* to, double t,
                              ob::State* state) const {
  const DubinsSampler sampler(ToPose(from), Curve(from, to));
  SetPose(sampler.At(t * sampler.length()), state);
}

void DubinsSpace::interpolate(const ob::State* from, const ob::State* to, double t, bool&,
                              DubinsPath&, ob::State* state) const {
  interpolate(from, to, t, state);
}

}  // namespace dbd
