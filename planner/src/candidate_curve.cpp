#include <dbd/planner/candidate_curve.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

int StepCount(double length) {
  return std::max(1, static_cast<int>(std::ceil(length / kPoseStep)));
}

}  // namespace

double CurveCost(const TrafficabilityLayer& layer, const Pose2& from, const DubinsCurve& curve) {
  const DubinsSampler sampler(from, curve);
  const int steps = StepCount(sampler.length());
  const double step = sampler.length() / steps;
  double rates = 0;
  for (int i = 1; i <= steps; ++i) {
    const Pose2 pose = sampler.At(i * step);
    rates += layer.SecondsPerMetre(pose.x, pose.y, pose.heading);
    if (std::isinf(rates)) return rates;
  }
  return rates * step;
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

double PosesCost(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses) {
  double cost = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double step = (poses[i].position() - poses[i - 1].position()).norm();
    cost += step * layer.SecondsPerMetre(poses[i].x, poses[i].y, poses[i].heading);
  }
  return cost;
}

bool AllGo(const TrafficabilityLayer& layer, const std::vector<Pose2>& poses) {
  return std::all_of(poses.begin(), poses.end(), [&](const Pose2& pose) {
    return layer.Evaluate(pose.x, pose.y, pose.heading).go();
  });
}

std::vector<Eigen::Vector2d> Positions(const std::vector<Pose2>& poses) {
  std::vector<Eigen::Vector2d> positions;
  positions.reserve(poses.size());
  for (const Pose2& pose : poses) positions.push_back(pose.position());
  return positions;
}

}  // namespace dbd
