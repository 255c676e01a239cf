#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/plan_types.h>
#include <dbd/planner/stop.h>

#include <Eigen/Core>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace dbd {

/// A dense, go route that may become a candidate.
struct RouteDraft {
  std::string origin;
  std::vector<Pose2> poses;
  double cost = 0;                ///< by the layer [s]
  std::vector<Pose2> unsmoothed;  ///< the route as it was found, empty when it is `poses`
  double unsmoothed_cost = 0;     ///< by the layer [s]
};

/// Keeps routes that differ from each other, in the order of their arrival.
class CandidatePool {
 public:
  explicit CandidatePool(double min_separation, std::stop_token stop = {})
      : min_separation_(min_separation), stop_(std::move(stop)) {}

  /// Routes that are there already: others must differ from them too.
  void AddKnown(const std::vector<Candidate>& known);

  /// Takes the route in when it is worthwhile, costing at most twice as much as the cheapest so
  /// far, and at least `share` of `min_separation` from every other; otherwise keeps it in reserve.
  /// Returns whether it was taken in.
  bool Offer(RouteDraft draft, double share = 1);

  /// Keeps a route for FillUp only.
  void Reserve(RouteDraft draft);

  /// Takes in routes from the reserve until there are `count`, each time the one that differs
  /// most from those taken in, worthwhile ones first; never the same trace twice. Throws
  /// StopRequested when asked to.
  void FillUp(int count);

  int size() const { return static_cast<int>(taken_.size()); }

  /// The routes taken in, in the order of their costs.
  std::vector<RouteDraft> TakeSorted();

 private:
  struct Entry {
    explicit Entry(RouteDraft route);

    RouteDraft draft;
    std::vector<Eigen::Vector2d> trace;
    // From the nearest route taken in, as far as it was compared.
    double separation = std::numeric_limits<double>::infinity();
  };

  bool IsWorthwhile(const Entry& entry) const;
  bool FillUpOnce(bool with_dear_ones);
  void CompareReserveWith(std::size_t first_taken);
  void CompareReserveWith(const std::vector<Eigen::Vector2d>& trace);

  double min_separation_;
  double cheapest_ = std::numeric_limits<double>::infinity();
  std::stop_token stop_;
  std::vector<std::vector<Eigen::Vector2d>> known_;  // traces
  std::vector<Entry> taken_;
  std::vector<Entry> reserve_;
};

}  // namespace dbd
