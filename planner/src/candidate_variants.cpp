#include "candidate_variants.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/candidate_smoother.h>
#include <dbd/planner/scoring.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "candidate_random.h"

namespace dbd {
namespace {

constexpr int kParents = 3;
constexpr int kTries = 12;              // to find a bend that holds
constexpr double kSpacing = 1.0;        // [m] of a bend's points
constexpr double kLeastBend = 0.7;      // [m] to one side
constexpr double kLargestBend = 5.0;    // [m]
constexpr double kShortestBend = 12.0;  // [m] from its middle to its end
constexpr double kLongestBend = 50.0;   // [m]
constexpr double kCurvatureTolerance = 1.05;
constexpr double kCurvatureWindow = 1.5;  // [m] to both sides
constexpr double kSlowFrom = 15.0;        // [m] before a tight place
constexpr double kSlowTo = 5.0;           // [m] after it
constexpr double kSlowShare = 0.7;        // of the speed that it was driven at
constexpr double kSlowest = 1.0;          // [m/s]
constexpr int kSmoothingAttempts = 200;

/// Limits that a lower speed eases.
bool DependsOnSpeed(const std::string& limit) {
  return limit == "shock" || limit == "absorbed_power" || limit == "load_transfer" ||
         limit == "roll" || limit == "pitch";
}

/// Indices of the best: by score, then, among those that did not arrive, by progress.
std::vector<std::size_t> BestOf(const DrivenCandidates& driven) {
  std::vector<std::size_t> order(driven.scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Score &one = driven.scores[a], &other = driven.scores[b];
    if (one.feasible != other.feasible) return one.feasible;
    if (one.feasible) return one.total < other.total;
    return driven.rollouts[a].progress > driven.rollouts[b].progress;
  });
  const bool any = !order.empty() && driven.scores[order[0]].feasible;
  std::size_t kept = std::min<std::size_t>(order.size(), kParents);
  while (any && kept > 1 && !driven.scores[order[kept - 1]].feasible) --kept;
  order.resize(kept);
  return order;
}

/// In an earlier round: once more would be the same drive.
bool WasSlowed(const DrivenCandidates& driven, std::size_t parent) {
  const Candidate& usual = driven.candidates[parent];
  return std::any_of(driven.candidates.begin(), driven.candidates.end(), [&](const Candidate& c) {
    return c.speed_caps.size() > usual.speed_caps.size() && c.path.points() == usual.path.points();
  });
}

std::vector<Pose2> PosesAlong(const Path& path) {
  const int steps = std::max(1, static_cast<int>(std::ceil(path.length() / kSpacing)));
  std::vector<Pose2> poses;
  for (int i = 0; i <= steps; ++i) {
    const double s = path.length() * i / steps;
    const Eigen::Vector2d p = path.Position(s);
    poses.push_back({p.x(), p.y(), path.VehicleHeading(s), path.StretchAt(s).reverse});
  }
  return poses;
}

/// Makes variants of one driven candidate.
class Variation {
 public:
  Variation(const TrafficabilityLayer& layer, double turning_radius, const Candidate& parent,
            const Rollout& rollout)
      : layer_(layer), turning_radius_(turning_radius), parent_(parent), rollout_(rollout) {}

  /// To one side of the parent, its middle near a place that matters or anywhere.
  std::optional<Candidate> Bend(SplitMix64& random) const {
    for (int i = 0; i < kTries; ++i) {
      const double middle = i % 2 == 0 ? ArcLengthOf(PlaceThatMatters(random))
                                       : random.Uniform() * parent_.path.length();
      const double room = std::min(middle, parent_.path.length() - middle) - kSpacing;
      const double half =
          std::min(room, kShortestBend + random.Uniform() * (kLongestBend - kShortestBend));
      const double size = kLeastBend + random.Uniform() * (kLargestBend - kLeastBend);
      const double side = random.Uniform() < 0.5 ? -1 : 1;
      if (half < kShortestBend / 2) continue;
      Candidate bent = Named("bend");
      bent.path = BentPath(middle, half, side * size);
      bent.meant = Path();
      if (Holds(bent.path)) return Priced(std::move(bent));
    }
    return std::nullopt;
  }

  std::optional<Candidate> Smoothed(std::uint64_t seed) const {
    SmoothingOptions options;
    options.attempts = kSmoothingAttempts;
    const SmoothedRoute after =
        SmoothRoute(layer_, turning_radius_, PosesAlong(parent_.path), options, seed);
    if (after.cost >= after.former_cost) return std::nullopt;
    Candidate smooth = Named("smooth");
    smooth.meant = Path();
    smooth.path =
        PathAlong(after.poses, parent_.path.points().front(), parent_.path.points().back());
    return Priced(std::move(smooth));
  }

  std::optional<Candidate> Slower() const {
    const LimitMargin* limit = TightestLimit(rollout_);
    if (limit == nullptr || !DependsOnSpeed(limit->name)) return std::nullopt;
    const double s = ArcLengthOf(limit->place);
    Candidate slower = Named("slower");
    const double speed = std::max(kSlowest, kSlowShare * SpeedNear(limit->s));
    slower.speed_caps.push_back({s - kSlowFrom, s + kSlowTo, speed});
    return Priced(std::move(slower));
  }

 private:
  Candidate Named(const char* how) const {
    Candidate variant = parent_;
    variant.origin = parent_.origin.substr(0, parent_.origin.find('+')) + "+" + how;
    return variant;
  }

  Candidate Priced(Candidate variant) const {
    variant.layer_cost = PosesCost(layer_, PosesAlong(variant.path));
    return variant;
  }

  double ArcLengthOf(const Eigen::Vector2d& place) const {
    return parent_.path.NearestArcLength(place, 0, parent_.path.length());
  }

  double SpeedNear(double s) const {
    const auto row = std::find_if(rollout_.trace.begin(), rollout_.trace.end(),
                                  [s](const TraceSample& sample) { return sample.s >= s; });
    return row == rollout_.trace.end() ? kSlowest : row->speed;
  }

  /// Where the drive failed; else its tightest place or, as often, the slowest of some places.
  Eigen::Vector2d PlaceThatMatters(SplitMix64& random) const {
    if (rollout_.outcome != Outcome::kReached) return rollout_.place.head<2>();
    const LimitMargin* limit = TightestLimit(rollout_);
    if (limit != nullptr && random.Uniform() < 0.5) return limit->place;
    constexpr int kLooks = 6;
    const TraceSample* slowest = nullptr;
    for (int i = 0; i < kLooks && !rollout_.trace.empty(); ++i) {
      const double share = 0.05 + 0.9 * random.Uniform();  // not where it starts and stops
      const auto index =
          static_cast<std::size_t>(share * static_cast<double>(rollout_.trace.size() - 1));
      const TraceSample& sample = rollout_.trace[index];
      if (slowest == nullptr || sample.speed < slowest->speed) slowest = &sample;
    }
    return slowest == nullptr ? parent_.path.Position(0) : Eigen::Vector2d(slowest->x, slowest->y);
  }

  Path BentPath(double middle, double half, double size) const {
    std::vector<Eigen::Vector2d> points;
    for (const Pose2& pose : PosesAlong(parent_.path)) {
      const double s = static_cast<double>(points.size()) * parent_.path.length() /
                       std::ceil(parent_.path.length() / kSpacing);
      const double u = std::clamp((s - middle) / half, -1.0, 1.0);
      const double aside = size * std::pow(std::cos(0.5 * std::numbers::pi * u), 2);
      points.emplace_back(pose.x - aside * std::sin(pose.heading),
                          pose.y + aside * std::cos(pose.heading));
    }
    return Path(points);
  }

  bool Holds(const Path& path) const {
    if (!AllGo(layer_, PosesAlong(path))) return false;
    const double sharpest = std::max(1 / turning_radius_, SharpestCurvature(parent_.path));
    return SharpestCurvature(path) <= kCurvatureTolerance * sharpest;
  }

  static double SharpestCurvature(const Path& path) {
    double sharpest = 0;
    for (double s = 0; s < path.length(); s += kSpacing) {
      sharpest = std::max(sharpest, std::abs(path.Curvature(s, kCurvatureWindow)));
    }
    return sharpest;
  }

  const TrafficabilityLayer& layer_;
  double turning_radius_;
  const Candidate& parent_;
  const Rollout& rollout_;
};

}  // namespace

std::vector<Candidate> VaryBest(const TrafficabilityLayer& layer, const VehicleModel& vehicle,
                                const DrivenCandidates& driven, int count, std::uint64_t seed) {
  const std::vector<std::size_t> best = BestOf(driven);
  std::vector<Candidate> variants;
  std::set<std::size_t> slowed;
  for (int i = 0; i < count && !best.empty(); ++i) {
    // The best has as many variants as all others together.
    const std::size_t rank = i % 2 == 0 ? 0 : static_cast<std::size_t>(i / 2) % best.size();
    const std::size_t parent = best[rank];
    const Variation variation(layer, vehicle.min_turning_radius(), driven.candidates[parent],
                              driven.rollouts[parent]);
    SplitMix64 random(DeriveSeed(seed, static_cast<std::uint64_t>(i)));
    std::optional<Candidate> variant;
    if (slowed.insert(parent).second && !WasSlowed(driven, parent)) variant = variation.Slower();
    // The places where the direction changes hang together: such a route keeps its shape.
    const bool keeps_shape = driven.candidates[parent].path.reverse_length() > 0;
    if (!variant && !keeps_shape && i % 4 == 1) variant = variation.Smoothed(random.Next());
    if (!variant && !keeps_shape) variant = variation.Bend(random);
    if (variant) variants.push_back(std::move(*variant));
  }
  return variants;
}

}  // namespace dbd
