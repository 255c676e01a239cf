#include "dubins_space.h"

#include "ompl_pose.h"

namespace dbd {

namespace ob = ompl::base;

DubinsSpace::DubinsSpace(double turning_radius, const Eigen::Vector2d& min_corner,
                         const Eigen::Vector2d& max_corner)
    : ob::DubinsStateSpace(turning_radius) {
  setBounds(Rectangle(min_corner, max_corner));
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
