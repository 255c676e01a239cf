#include "candidate_guides.h"

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

constexpr double kTurnAside = 0.35;  // [rad]

}  // namespace

std::vector<Pose2> GuidePoses(const TrafficabilityLayer& layer,
                              const std::vector<Eigen::Vector2d>& way, double turning_radius) {
  std::vector<Pose2> guides;
  const auto spacing = static_cast<std::size_t>(
      std::max(1.0, std::round(0.75 * turning_radius / layer.resolution())));
  for (std::size_t i = spacing; i + spacing < way.size(); i += spacing) {
    // The moves of a way zigzag: its direction shows over a turning radius.
    const Eigen::Vector2d along = way[i + spacing] - way[i - spacing];
    const double heading = std::atan2(along.y(), along.x());
    for (const double aside : {0.0, kTurnAside, -kTurnAside}) {
      const Pose2 pose{way[i].x(), way[i].y(), WrapAngle(heading + aside)};
      if (layer.Evaluate(pose.x, pose.y, pose.heading).go()) guides.push_back(pose);
    }
  }
  return guides;
}

}  // namespace dbd
