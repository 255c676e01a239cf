#include "dubins_space.h"

#include <functional>

#include "ompl_pose.h"

namespace dbd {

namespace ob = ompl::base;

namespace {
// More than a planner compares with one state; a power of two, so that no division finds the place.
constexpr std::size_t kKnownDistances = 4096;
}  // namespace

DubinsSpace::DubinsSpace(double turning_radius, const Eigen::Vector2d& min_corner,
                         const Eigen::Vector2d& max_corner)
    : ob::DubinsStateSpace(turning_radius), known_(kKnownDistances) {
  setBounds(Rectangle(min_corner, max_corner));
}

DubinsCurve DubinsSpace::Curve(const ob::State* from, const ob::State* to) const {
  return ShortestDubinsCurve(ToPose(from), ToPose(to), rho_);
}

double DubinsSpace::distance(const ob::State* from, const ob::State* to) const {
  const Pose2 a = ToPose(from), b = ToPose(to);
  // States stay where they are, so that their addresses tell most of them apart.
  const std::hash<const ob::State*> hash;
  KnownDistance& known = known_[(hash(from) / sizeof(double) + 31 * hash(to)) % kKnownDistances];
  const std::array<double, 6> ends{a.x, a.y, a.heading, b.x, b.y, b.heading};
  if (known.ends != ends) {
    // One of the ends is mostly that of the last question.
    if (a.heading != last_from_.heading) last_from_ = DirectedPose(a);
    if (b.heading != last_to_.heading) last_to_ = DirectedPose(b);
    last_from_.x = a.x, last_from_.y = a.y;
    last_to_.x = b.x, last_to_.y = b.y;
    known = {ends, ShortestDubinsCurve(last_from_, last_to_, rho_).length()};
  }
  return known.length;
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
