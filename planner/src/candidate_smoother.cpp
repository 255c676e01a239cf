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

/// Puts `with` in the place of the entries `first` to `last`.
template <typename T>
void Replace(std::vector<T>& entries, std::size_t first, std::size_t last,
             const std::vector<T>& with) {
  std::vector<T> joined;
  joined.reserve(entries.size() - (last + 1 - first) + with.size());
  const auto begin = entries.begin();
  joined.insert(joined.end(), begin, begin + static_cast<std::ptrdiff_t>(first));
  joined.insert(joined.end(), with.begin(), with.end());
  joined.insert(joined.end(), begin + static_cast<std::ptrdiff_t>(last) + 1, entries.end());
  entries = std::move(joined);
}

class Smoother {
 public:
  Smoother(const TrafficabilityLayer& layer, double turning_radius, std::vector<Pose2> poses)
      : layer_(layer), turning_radius_(turning_radius), poses_(std::move(poses)) {
    steps_ = StepCosts(poses_);
    SumSteps(1);
  }

  // Tries to replace the poses between `first` and `last` by one curve between the given ends,
  // which are where those are, with other headings perhaps at the ends of the route.
  void TryCurve(std::size_t first, std::size_t last, const Pose2& from, const Pose2& to) {
    const DubinsCurve curve = ShortestDubinsCurve(from, to, turning_radius_);
    const double present = costs_[last] - costs_[first];
    if (curve.length() * layer_.min_seconds_per_metre() >= present) return;
    if (!layer_.Evaluate(from.x, from.y, from.heading).go()) return;
    if (!(CurveCost(layer_, from, curve, present) < present)) return;
    const std::vector<Pose2> part = DensePoses({from, to}, turning_radius_);
    std::vector<double> part_steps = StepCosts(part);
    part_steps.front() = steps_[first];
    Replace(poses_, first, last, part);
    Replace(steps_, first, last, part_steps);
    SumSteps(first + 1);
  }

  const std::vector<Pose2>& poses() const { return poses_; }
  double cost() const { return costs_.back(); }
  std::vector<Pose2> TakePoses() { return std::move(poses_); }

 private:
  std::vector<double> StepCosts(const std::vector<Pose2>& poses) const {
    std::vector<double> steps(poses.size(), 0.0);
    for (std::size_t i = 1; i < poses.size(); ++i) {
      steps[i] = StepCost(layer_, poses[i - 1], poses[i]);
    }
    return steps;
  }

  void SumSteps(std::size_t first) {
    costs_.resize(steps_.size());
    for (std::size_t i = first; i < steps_.size(); ++i) costs_[i] = costs_[i - 1] + steps_[i];
  }

  const TrafficabilityLayer& layer_;
  double turning_radius_;
  std::vector<Pose2> poses_;
  std::vector<double> steps_;  // what each pose costs from the one before [s], 0 for the first
  std::vector<double> costs_;  // from the first pose to each [s]
};

}  // namespace

SmoothedRoute SmoothRoute(const TrafficabilityLayer& layer, double turning_radius,
                          std::vector<Pose2> poses, const SmoothingOptions& options,
                          std::uint64_t seed) {
  if (poses.size() < 3) {
    const double cost = PosesCost(layer, poses);
    return {std::move(poses), cost, cost};
  }
  Smoother smoother(layer, turning_radius, std::move(poses));
  const double former_cost = smoother.cost();
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
  const double cost = smoother.cost();
  return {smoother.TakePoses(), former_cost, cost};
}

}  // namespace dbd
