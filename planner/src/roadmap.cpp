#include <dbd/planner/roadmap.h>

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include <tbb/parallel_for.h>

#include "candidate_random.h"
#include "roadmap_neighbours.h"

namespace dbd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A disc in which neighbours are looked for holds about this many samples: with free headings
// about one in four is joined by a curve without much detour.
constexpr double kNodesInDisc = 60.0;

// Edges of less than about a full turn's reach are all detour.
constexpr double kLeastReachInRadii = 4.0;

// Starts and goals must get out of tight places: more and longer edges than inner nodes.
constexpr int kEndNeighbourFactor = 3;

// One direct edge stands for a whole row of nodes: found once, it should not be found again soon.
constexpr double kDirectFactor = 10.0;

// Element `index` of the van der Corput sequence.
double RadicalInverse(int index, int base) {
  double value = 0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) {
    value += digit * (index % base);
  }
  return value;
}

double Fraction(double value) { return value - std::floor(value); }

}  // namespace

Roadmap::Roadmap(const TrafficabilityLayer& layer, double turning_radius, const RoadmapQuery& query,
                 const RoadmapOptions& options, std::stop_token stop)
    : layer_(&layer), turning_radius_(turning_radius), stop_(std::move(stop)) {
  SampleNodes(query, options);
  BuildEdges(options, (query.max_corner - query.min_corner).prod());
  penalties_.assign(nodes_.size(), 1.0);
  for (const Pose2& node : nodes_) least_to_go_.push_back(LeastCostToGo(node));
}

Roadmap::~Roadmap() = default;

void Roadmap::SampleNodes(const RoadmapQuery& query, const RoadmapOptions& options) {
  starts_ = static_cast<int>(query.starts.size());
  goals_ = static_cast<int>(query.goals.size());
  nodes_ = query.starts;
  nodes_.insert(nodes_.end(), query.goals.begin(), query.goals.end());
  nodes_.insert(nodes_.end(), query.guides.begin(), query.guides.end());
  if (query.starts.empty() || query.goals.empty()) return;
  const Eigen::Vector2d ahead = query.goals[0].position() - query.starts[0].position();
  const double forward = std::atan2(ahead.y(), ahead.x());
  const Eigen::Vector2d extent = query.max_corner - query.min_corner;
  SplitMix64 random(options.seed);
  const double shift[3] = {random.Uniform(), random.Uniform(), random.Uniform()};
  constexpr int kTriesPerNode = 8;
  int found = 0;
  for (int i = 1; found < options.nodes && i < kTriesPerNode * options.nodes; ++i) {
    ThrowIfStopped(stop_);
    const double u = 2.0 * Fraction(RadicalInverse(i, 5) + shift[2]) - 1.0;
    const double turned = std::copysign(std::pow(std::abs(u), 1.5), u) * std::numbers::pi;
    const Pose2 pose{query.min_corner.x() + extent.x() * Fraction(RadicalInverse(i, 2) + shift[0]),
                     query.min_corner.y() + extent.y() * Fraction(RadicalInverse(i, 3) + shift[1]),
                     WrapAngle(forward + turned)};
    if (!layer_->Evaluate(pose.x, pose.y, pose.heading).go()) continue;
    nodes_.push_back(pose);
    ++found;
  }
}

void Roadmap::BuildEdges(const RoadmapOptions& options, double area) {
  const int count = node_count();
  edges_.assign(count, {});
  if (count == 0) return;
  const double spread = std::sqrt(kNodesInDisc * area / (std::numbers::pi * count));
  const double radius = std::max(spread, kLeastReachInRadii * turning_radius_);
  places_ = std::make_unique<NeighbourGrid>(nodes_, radius);
  // Each node is an end of some hundred curves.
  std::vector<DirectedPose> poses;
  for (const Pose2& node : nodes_) poses.emplace_back(node);
  tbb::parallel_for(0, count, [&](int node) {
    if (IsGoal(node)) return;
    ThrowIfStopped(stop_);
    std::vector<int> nearby = places_->Within(nodes_[node].position(), radius);
    if (IsStart(node)) {
      for (int goal = starts_; goal < starts_ + goals_; ++goal) nearby.push_back(goal);
      std::sort(nearby.begin(), nearby.end());
      nearby.erase(std::unique(nearby.begin(), nearby.end()), nearby.end());
    }
    edges_[node] = EdgesFrom(node, nearby, poses, options, radius);
  });
}

std::vector<Roadmap::Edge> Roadmap::EdgesFrom(int node, const std::vector<int>& nearby,
                                              const std::vector<DirectedPose>& poses,
                                              const RoadmapOptions& options, double radius) const {
  struct Option {
    double length;
    int to;
    DubinsCurve curve;
  };
  const DirectedPose& from = poses[node];
  const double longest_end_curve = 2.0 * radius;
  std::vector<Option> choices;
  std::vector<Edge> edges;
  const auto add = [&](int to, const DubinsCurve& curve) {
    const double cost = CurveCost(*layer_, from, curve);
    if (std::isfinite(cost)) edges.push_back({to, cost});
  };
  for (const int to : nearby) {
    if (to == node || IsStart(to)) continue;
    const DubinsCurve curve = ShortestDubinsCurve(from, poses[to], turning_radius_);
    const double length = curve.length();
    const double straight = (nodes_[to].position() - from.position()).norm();
    if (IsGoal(to)) {
      if (IsStart(node) || length < longest_end_curve) add(to, curve);
    } else if (length < options.max_detour * straight ||
               (IsStart(node) && length < longest_end_curve)) {
      choices.push_back({length, to, curve});
    }
  }
  const std::size_t most =
      static_cast<std::size_t>(options.neighbours) * (IsStart(node) ? kEndNeighbourFactor : 1);
  const std::size_t kept = std::min(most, choices.size());
  std::partial_sort(choices.begin(), choices.begin() + kept, choices.end(),
                    [](const Option& a, const Option& b) {
                      return std::pair(a.length, a.to) < std::pair(b.length, b.to);
                    });
  for (std::size_t i = 0; i < kept; ++i) add(choices[i].to, choices[i].curve);
  return edges;
}

double Roadmap::LeastCostToGo(const Pose2& node) const {
  double nearest = kInfinity;
  for (int goal = starts_; goal < starts_ + goals_; ++goal) {
    nearest = std::min(nearest, (nodes_[goal].position() - node.position()).norm());
  }
  return nearest * layer_->min_seconds_per_metre();
}

double Roadmap::Weight(int from, int to) const {
  if (IsStart(from) && IsGoal(to)) return direct_penalty_;
  return 0.5 * (penalties_[from] + penalties_[to]);
}

std::vector<Pose2> Roadmap::FindRoute() const {
  // A*: the entry with the least cost so far plus cost to go first, ties by node.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> cost(nodes_.size(), kInfinity);
  std::vector<int> parent(nodes_.size(), -1);
  std::vector<char> closed(nodes_.size(), 0);
  for (int start = 0; start < starts_; ++start) {
    cost[start] = 0;
    open.push({least_to_go_[start], start});
  }
  while (!open.empty()) {
    ThrowIfStopped(stop_);
    const int node = open.top().second;
    open.pop();
    if (closed[node]) continue;
    closed[node] = 1;
    if (IsGoal(node)) {
      std::vector<Pose2> route;
      for (int at = node; at >= 0; at = parent[at]) route.push_back(nodes_[at]);
      std::reverse(route.begin(), route.end());
      return route;
    }
    for (const Edge& edge : edges_[node]) {
      const double reached = cost[node] + Weight(node, edge.to) * edge.cost;
      if (reached >= cost[edge.to]) continue;
      cost[edge.to] = reached;
      parent[edge.to] = node;
      open.push({reached + least_to_go_[edge.to], edge.to});
    }
  }
  return {};
}

void Roadmap::Penalize(const std::vector<Eigen::Vector2d>& polyline, double width,
                       double strength) {
  if (starts_ == 0 || goals_ == 0 || polyline.empty()) return;
  // Only nodes about the polyline's points are measured against all of it.
  std::vector<char> nearby(nodes_.size(), 0);
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    const double segment = i > 0 ? (polyline[i] - polyline[i - 1]).norm() : 0.0;
    for (const int node : places_->Within(polyline[i], width + segment)) nearby[node] = 1;
  }
  for (int node = starts_ + goals_; node < node_count(); ++node) {
    if (!nearby[node]) continue;
    const double distance = DistanceToPolyline(nodes_[node].position(), polyline);
    if (distance < width) penalties_[node] += strength * (1.0 - distance / width);
  }
  // A direct edge has no inner node that could bear the penalty.
  const Eigen::Vector2d middle = 0.5 * (nodes_[0].position() + nodes_[starts_].position());
  const double distance = DistanceToPolyline(middle, polyline);
  if (distance < width) direct_penalty_ += strength * kDirectFactor * (1.0 - distance / width);
}

void Roadmap::ClearPenalties() {
  std::fill(penalties_.begin(), penalties_.end(), 1.0);
  direct_penalty_ = 1.0;
}

int Roadmap::edge_count() const {
  int count = 0;
  for (const auto& edges : edges_) count += static_cast<int>(edges.size());
  return count;
}

}  // namespace dbd
