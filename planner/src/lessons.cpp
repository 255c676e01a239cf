#include <dbd/planner/lessons.h>
#include <dbd/planner/scoring.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

constexpr double kCell = 4.0;             // [m]
constexpr double kFailureRadius = 12.0;   // [m] some vehicle lengths
constexpr double kFailureSeconds = 60.0;  // a detour of some hundred metres
constexpr double kShortestStep = 0.05;    // [m] between rows of a trace
constexpr double kSlowest = 20.0;         // [s/m] nothing that moves is slower

ExtraCost Blank(const TrafficabilityLayer& layer) {
  return ExtraCost(layer.min_corner(), layer.max_corner(), std::max(kCell, layer.resolution()));
}

/// Time that rows of traces took and should have taken.
struct Pace {
  double metres = 0;
  double taken = 0;     // [s]
  double expected = 0;  // [s]
};

/// One entry per cell of `grid`, and `total` over all of them.
struct PaceMap {
  std::vector<Pace> cells;
  std::vector<Eigen::Vector2d> places;  // one in each cell that was driven through
  Pace total;
};

void AddStep(const TrafficabilityLayer& layer, const ExtraCost& grid, const TraceSample& from,
             const TraceSample& to, PaceMap& paces) {
  const double length = to.s - from.s;
  const Eigen::Vector2d middle(0.5 * (from.x + to.x), 0.5 * (from.y + to.y));
  const int index = grid.IndexOf(middle);
  const double expected = layer.SecondsPerMetre(middle.x(), middle.y(), from.yaw);
  if (length < kShortestStep || index < 0 || !std::isfinite(expected)) return;
  Pace& cell = paces.cells[static_cast<std::size_t>(index)];
  if (cell.metres == 0) paces.places.push_back(middle);
  for (Pace* pace : {&cell, &paces.total}) {
    pace->metres += length;
    pace->taken += std::min(to.t - from.t, kSlowest * length);
    pace->expected += expected * length;
  }
}

void AddSlowPlaces(const TrafficabilityLayer& layer, const std::vector<Rollout>& rollouts,
                   ExtraCost& lessons) {
  PaceMap paces;
  paces.cells.resize(static_cast<std::size_t>(lessons.columns()) *
                     static_cast<std::size_t>(lessons.rows()));
  for (const Rollout& rollout : rollouts) {
    for (std::size_t i = 1; i < rollout.trace.size(); ++i) {
      AddStep(layer, lessons, rollout.trace[i - 1], rollout.trace[i], paces);
    }
  }
  if (paces.total.expected <= 0) return;
  const double common = paces.total.taken / paces.total.expected;
  for (const Eigen::Vector2d& place : paces.places) {
    const Pace& pace = paces.cells[static_cast<std::size_t>(lessons.IndexOf(place))];
    const double extra = (pace.taken / common - pace.expected) / pace.metres;
    if (extra > 0) lessons.AddAt(place, extra);
  }
}

}  // namespace

ExtraCost LearnFromRollouts(const TrafficabilityLayer& layer, const std::vector<Rollout>& rollouts,
                            const ScoringOptions& scoring) {
  ExtraCost lessons = Blank(layer);
  ExtraCost tight = Blank(layer);
  for (const Rollout& rollout : rollouts) {
    if (rollout.outcome == Outcome::kTimedOut) continue;  // no one place is to blame
    if (rollout.outcome != Outcome::kReached) {
      lessons.AddCone(rollout.place.head<2>(), kFailureRadius, kFailureSeconds);
    } else if (const LimitMargin* limit = TightestLimit(rollout)) {
      tight.RaiseToCone(limit->place, kFailureRadius, RiskCost(rollout, scoring));
    }
  }
  lessons.Add(tight);
  AddSlowPlaces(layer, rollouts, lessons);
  return lessons;
}

}  // namespace dbd
