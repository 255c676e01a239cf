#include <dbd/planner/candidate_smoother.h>

#include <dbd/planner/candidate_curve.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "candidate_random.h"

namespace dbd {
namespace {

double HeadingTo(const Pose2& from, const Pose2& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

class Smoother {
 public:
  Smoother(const TrafficabilityLayer& layer, double turning_radius, std::vector<Pose2> poses)
      : layer_(layer), turning_radius_(turning_radius), poses_(std::move(poses)) {
    SumCosts(0);
  }

  // Tries to replace the poses between `first` and `last` by one curve between the given ends.
  void TryCurve(std::size_t first, std::size_t last, const Pose2& from, const Pose2& to) {
    const DubinsCurve curve = ShortestDubinsCurve(from, to, turning_radius_);
    const double present = costs_[last] - costs_[first];
    if (curve.length() * layer_.min_seconds_per_metre() >= present) return;
    if (!layer_.Evaluate(from.x, from.y, from.heading).go()) return;
    if (!(CurveCost(layer_, from, curve) < present)) return;
    const std::vector<Pose2> part = DensePoses({from, to}, turning_radius_);
    std::vector<Pose2> joined(poses_.begin(), poses_.begin() + first);
    joined.insert(joined.end(), part.begin(), part.end());
    joined.insert(joined.end(), poses_.begin() + last + 1, poses_.end());
    poses_ = std::move(joined);
    SumCosts(first);
  }

  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  void SumCosts(std::size_t first) {
    costs_.resize(poses_.size());
    costs_[0] = 0;
    for (std::size_t i = std::max<std::size_t>(first, 1); i < poses_.size(); ++i) {
      costs_[i] = costs_[i - 1] + StepCost(layer_, poses_[i - 1], poses_[i]);
    }
  }

  const TrafficabilityLayer& layer_;
  double turning_radius_;
  std::vector<Pose2> poses_;
  std::vector<double> costs_;  // from the first pose to each [s]
};

}  // namespace

std::vector<Pose2> SmoothRoute(const TrafficabilityLayer& layer, double turning_radius,
                               std::vector<Pose2> poses, const SmoothingOptions& options,
                               std::uint64_t seed) {
  if (poses.size() < 3) return poses;
  Smoother smoother(layer, turning_radius, std::move(poses));
  SplitMix64 random(seed);
  const double longest = options.longest / kPoseStep;
  for (int attempt = 0; attempt < options.attempts; ++attempt) {
    const std::vector<Pose2>& now = smoother.poses();
    const std::size_t last_pose = now.size() - 1;
    const auto reach = static_cast<std::size_t>(2.0 + (longest - 2.0) * random.Uniform());
    // Starts before the route's beginning are held there, so that the ends get their share.
    const double begin =
        random.Uniform() * static_cast<double>(last_pose + reach) - static_cast<double>(reach);
    const auto first = static_cast<std::size_t>(std::max(0.0, begin));
    const auto last = std::min(
        last_pose, static_cast<std::size_t>(std::max(2.0, begin + static_cast<double>(reach))));
    if (last < first + 2) continue;
    Pose2 from = now[first];
    Pose2 to = now[last];
    const bool turn_start = options.free_start && first == 0;
    const bool turn_goal = options.free_goal && last == last_pose;
    if (turn_start) from.heading = HeadingTo(from, to);
    if (turn_goal) to.heading = HeadingTo(from, to);
    smoother.TryCurve(first, last, from, to);
  }
  return smoother.poses();
}

}  // namespace dbd
