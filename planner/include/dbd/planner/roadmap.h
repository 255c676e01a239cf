#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

namespace dbd {

class NeighbourGrid;

struct RoadmapOptions {
  int nodes = 3000;         ///< sampled, besides the ends and the guides
  int neighbours = 14;      ///< most edges that leave a node
  double max_detour = 1.6;  ///< longest curve of an edge / its straight distance
  std::uint64_t seed = 1;
};

/// What a roadmap spans and must join. Any of the starts may be left, any of the goals reached.
struct RoadmapQuery {
  std::vector<Pose2> starts;
  std::vector<Pose2> goals;
  std::vector<Pose2> guides;  ///< poses that should be nodes: through narrow places
  Eigen::Vector2d min_corner = Eigen::Vector2d::Zero();  ///< where nodes are sampled [m, W]
  Eigen::Vector2d max_corner = Eigen::Vector2d::Zero();
};

/// A directed graph of poses joined by Dubins curves, each priced by the trafficability layer.
///
/// Directed, because a Dubins curve cannot be driven backwards. Nodes are a Halton sequence,
/// shifted by the seed, over the rectangle and the headings, with more headings towards the goal;
/// no-go nodes and edges are left out. Edges are built in parallel in the caller's task arena,
/// with the same result for any number of threads. Building and searching throw StopRequested soon
/// after `stop` was asked to.
class Roadmap {
 public:
  Roadmap(const TrafficabilityLayer& layer, double turning_radius, const RoadmapQuery& query,
          const RoadmapOptions& options, std::stop_token stop = {});
  ~Roadmap();
  Roadmap(const Roadmap&) = delete;
  Roadmap& operator=(const Roadmap&) = delete;

  /// Waypoints of the cheapest route from a start to a goal under the present penalties; empty
  /// when there is none.
  std::vector<Pose2> FindRoute() const;

  /// Makes nodes within `width` [m] of a polyline dearer: by `strength` on it, less further off.
  void Penalize(const std::vector<Eigen::Vector2d>& polyline, double width, double strength);
  void ClearPenalties();

  int node_count() const { return static_cast<int>(nodes_.size()); }
  int edge_count() const;

 private:
  struct Edge {
    int to = 0;
    double cost = 0;  // [s]
  };

  void SampleNodes(const RoadmapQuery& query, const RoadmapOptions& options);
  void BuildEdges(const RoadmapOptions& options, double area);
  std::vector<Edge> EdgesFrom(int node, const std::vector<int>& nearby,
                              const std::vector<DirectedPose>& poses, const RoadmapOptions& options,
                              double radius) const;
  double Weight(int from, int to) const;
  bool IsStart(int node) const { return node < starts_; }
  bool IsGoal(int node) const { return node >= starts_ && node < starts_ + goals_; }
  double LeastCostToGo(const Pose2& node) const;

  const TrafficabilityLayer* layer_;
  double turning_radius_;
  std::stop_token stop_;
  int starts_ = 0;  // nodes_: starts, then goals, then guides, then samples
  int goals_ = 0;
  std::vector<Pose2> nodes_;
  std::unique_ptr<const NeighbourGrid> places_;  // of nodes_; null when there are none
  std::vector<std::vector<Edge>> edges_;
  std::vector<double> least_to_go_;  // to the nearest goal [s]
  std::vector<double> penalties_;    // factor per node, 1 = none
  double direct_penalty_ = 1;        // of the edges from a start straight to a goal
};

}  // namespace dbd
