#include <dbd/core/driver.h>
#include <dbd/planner/candidate_curve.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int StepCount(double length) {
  return std::max(1, static_cast<int>(std::ceil(length / kPoseStep)));
}

double StepRate(const TrafficabilityLayer& layer, const DirectedPose& pose) {
  const double rate = layer.SecondsPerMetre(pose);
  return pose.reverse ? std::max(rate, 1 / kReverseSpeed) + kReverseCost : rate;
}

}  // namespace

double CurveCost(const TrafficabilityLayer& layer, const Pose2& from, const DubinsCurve& curve,
                 double limit) {
  const DubinsSampler sampler(from, curve);
  const int steps = StepCount(sampler.length());
  const double step = sampler.length() / steps;
  // What the rates add up to at the limit, with room for rounding.
  const double most = (1 + 1e-9) * limit / step;
  double rates = 0;
  DirectedPose next = sampler.At(step);
  for (int i = 1; i <= steps; ++i) {
    const DirectedPose pose = next;
    next = sampler.At((i + 1) * step);
    layer.Prefetch(next);
    rates += StepRate(layer, pose);
    const double at_least = rates + (steps - i) * layer.min_seconds_per_metre();
    if (!(at_least <= most) || std::isinf(rates)) return kInfinity;
  }
  return rates * step + (from.reverse != curve.reverse ? kGearChangeCost : 0);
}

double WaypointsCost(const TrafficabilityLayer& layer, Pose2 from,
                     const std::vector<Pose2>& waypoints, double turning_radius) {
  double cost = 0;
  for (const Pose2& to : waypoints) {
    cost += CurveCost(layer, from, ShortestDubinsCurve(from, to, turning_radius));
    if (std::isinf(cost)) break;
    from = to;
  }
  return cost;
}

std::vector<Pose2> DensePoses(const std::vector<Pose2>& waypoints, double turning_radius) {
  if (waypoints.empty()) return {};
  std::vector<Pose2> poses{waypoints.front()};
  for (std::size_t leg = 0; leg + 1 < waypoints.size(); ++leg) {
    const DubinsSampler sampler(
        waypoints[leg], ShortestDubinsCurve(waypoints[leg], waypoints[leg + 1], turning_radius));
    const int steps = StepCount(sampler.length());
    for (int i = 1; i < steps; ++i) poses.push_back(sampler.At(i * sampler.length() / steps));
    poses.push_back(waypoints[leg + 1]);
  }
  return poses;
}

double StepCost(const TrafficabilityLayer& layer, const Pose2& from, const Pose2& to) {
  const double length = (to.position() - from.position()).norm();
  const double cost = length * StepRate(layer, DirectedPose(to));
  return from.reverse == to.reverse ? cost : cost + kGearChangeCost;
}

double PosesCost(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses) {
  double cost = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) cost += StepCost(layer, poses[i - 1], poses[i]);
  return cost;
}

bool AllGo(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses) {
  return std::all_of(poses.begin(), poses.end(), [&](const Pose2& pose) {
    return layer.Evaluate(pose.x, pose.y, pose.heading).go();
  });
}

bool Reverses(const std::vector<Pose2>& poses) {
  return std::any_of(poses.begin() + !poses.empty(), poses.end(),
                     [](const Pose2& pose) { return pose.reverse; });
}

Path PathAlong(const std::vector<Pose2>& poses, const Eigen::Vector2d& start,
               const Eigen::Vector2d& goal) {
  std::vector<Eigen::Vector2d> points = Positions(poses);
  points.front() = start;
  points.back() = goal;
  std::vector<bool> reverse;
  for (const Pose2& pose : poses) reverse.push_back(pose.reverse);
  return Path(points, reverse);
}

std::vector<Eigen::Vector2d> Positions(const std::vector<Pose2>& poses) {
  std::vector<Eigen::Vector2d> positions;
  positions.reserve(poses.size());
  for (const Pose2& pose : poses) positions.push_back(pose.position());
  return positions;
}

}  // namespace dbd
