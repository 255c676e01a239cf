#include "lattice_search.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/stop.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <queue>
#include <unordered_set>
#include <utility>

#include "cost_to_go.h"
#include "reeds_shepp.h"

namespace dbd {
namespace {

constexpr int kHeadings = 48;
constexpr double kStepInRadii = 0.4;  // of a successor; the turns are 23 degrees
constexpr double kCellInRadii = 0.2;  // poses nearer to each other than this are one
constexpr double kGreed = 1.4;        // weight of the cost to go: a way soon, not the cheapest
constexpr double kNearGoal = 3.0;     // [radii] every pose tries to reach the goal
constexpr double kSeesGoal = 8.0;     // [radii] every so many
constexpr int kSeldom = 8;
constexpr double kLongestWaypoint = 1.2;  // [radii] between waypoints, roughly

/// A pose that was met, by index.
struct Node {
  Pose2 pose;
  int parent = -1;
  double cost = 0;  // [s] from the start
};

class Lattice {
 public:
  Lattice(const TrafficabilityLayer& layer, double radius, const RoadmapQuery& query,
          bool reversing, const std::stop_token& stop)
      : layer_(layer),
        radius_(radius),
        query_(query),
        field_(layer, query.goals.front().position(), query.min_corner, query.max_corner, stop) {
    if (reversing) reeds_shepp_.emplace(radius, query.min_corner, query.max_corner);
    for (const Pose2& start : query.starts) Meet(start, -1, 0);
  }

  /// Looks at the most promising pose that is open; false when there is none. What was found is in
  /// `way` then.
  bool Step() {
    if (open_.empty()) return false;
    const int at = open_.top().second;
    open_.pop();
    if (!closed_.insert(Key(nodes_[static_cast<std::size_t>(at)].pose)).second) return true;
    ++looked_at_;
    if (ReachesGoal(at)) return false;
    Expand(at);
    return true;
  }

  std::vector<Pose2> way;
  int looked_at() const { return looked_at_; }

 private:
  void Meet(const Pose2& pose, int parent, double cost) {
    const double to_go = field_.At(pose.x, pose.y);
    if (!std::isfinite(to_go) || closed_.contains(Key(pose))) return;
    nodes_.push_back({pose, parent, cost});
    open_.push({cost + kGreed * to_go, static_cast<int>(nodes_.size()) - 1});
  }

  void Expand(int at) {
    const Node from = nodes_[static_cast<std::size_t>(at)];
    for (const Turn turn : {Turn::kStraight, Turn::kLeft, Turn::kRight}) {
      GoOn(at, from, turn, false);
      if (reeds_shepp_) GoOn(at, from, turn, true);
    }
  }

  void GoOn(int at, const Node& from, Turn turn, bool reverse) {
    DubinsCurve curve;
    curve.turns[0] = turn;
    curve.lengths[0] = kStepInRadii * radius_;
    curve.radius = radius_;
    curve.reverse = reverse;
    const double cost = CurveCost(layer_, from.pose, curve);
    if (!std::isfinite(cost)) return;
    Meet(DubinsSampler(from.pose, curve).At(curve.length()), at, from.cost + cost);
  }

  bool ReachesGoal(int at) {
    const Pose2 pose = nodes_[static_cast<std::size_t>(at)].pose;
    const double far = (query_.goals.front().position() - pose.position()).norm() / radius_;
    if (far > kSeesGoal || (far > kNearGoal && looked_at_ % kSeldom != 0)) return false;
    for (const Pose2& goal : query_.goals) {
      const std::vector<Pose2> end = CheapestEnd(pose, goal);
      if (end.empty()) continue;
      way = WayTo(at);
      way.insert(way.end(), end.begin(), end.end());
      return true;
    }
    return false;
  }

  /// Waypoints after `pose`; none when no curve is go.
  std::vector<Pose2> CheapestEnd(const Pose2& pose, const Pose2& goal) const {
    const double forward = WaypointsCost(layer_, pose, {goal}, radius_);
    if (reeds_shepp_) {
      std::vector<Pose2> pieces = reeds_shepp_->Waypoints(pose, goal);
      if (WaypointsCost(layer_, pose, pieces, radius_) < forward) return pieces;
    }
    return std::isfinite(forward) ? std::vector<Pose2>{goal} : std::vector<Pose2>{};
  }

  std::vector<Pose2> WayTo(int at) const {
    std::vector<Pose2> poses;
    for (; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
      poses.push_back(nodes_[static_cast<std::size_t>(at)].pose);
    }
    std::reverse(poses.begin(), poses.end());
    return poses;
  }

  std::uint64_t Key(const Pose2& pose) const {
    const double cell = kCellInRadii * radius_;
    const auto column = static_cast<std::uint64_t>((pose.x - layer_.min_corner().x()) / cell);
    const auto row = static_cast<std::uint64_t>((pose.y - layer_.min_corner().y()) / cell);
    const double turned = pose.heading / (2 * std::numbers::pi);
    const auto heading = static_cast<std::uint64_t>((turned - std::floor(turned)) * kHeadings);
    return (column << 36) | (row << 8) | (pose.reverse ? 128u : 0u) | heading;
  }

  const TrafficabilityLayer& layer_;
  double radius_;
  const RoadmapQuery& query_;
  std::optional<ReedsSheppSpace> reeds_shepp_;  // none: forward only
  CostToGoField field_;
  std::vector<Node> nodes_;
  using Entry = std::pair<double, int>;  // cost of the way through it, index; ties by index
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::unordered_set<std::uint64_t> closed_;
  int looked_at_ = 0;
};

/// Leaves out waypoints between which one curve, not longer than a turning radius or so, is go.
std::vector<Pose2> Thinned(const TrafficabilityLayer& layer, double radius,
                           const std::vector<Pose2>& way) {
  std::vector<Pose2> kept{way.front()};
  for (std::size_t i = 2; i < way.size(); ++i) {
    const DubinsCurve curve = ShortestDubinsCurve(kept.back(), way[i], radius);
    const bool serves = way[i].reverse == way[i - 1].reverse &&
                        curve.length() <= kLongestWaypoint * radius &&
                        std::isfinite(CurveCost(layer, kept.back(), curve));
    if (!serves) kept.push_back(way[i - 1]);
  }
  kept.push_back(way.back());
  return kept;
}

}  // namespace

std::vector<Pose2> SearchLattice(const TrafficabilityLayer& layer, double turning_radius,
                                 const RoadmapQuery& query, const LatticeOptions& options,
                                 const std::stop_token& stop) {
  if (query.starts.empty() || query.goals.empty()) return {};
  Lattice lattice(layer, turning_radius, query, options.reversing, stop);
  while (lattice.looked_at() < options.expansions && lattice.Step()) ThrowIfStopped(stop);
  if (lattice.way.empty()) return {};
  return Thinned(layer, turning_radius, lattice.way);
}

}  // namespace dbd
