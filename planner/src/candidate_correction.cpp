#include "candidate_correction.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dbd {
namespace {

constexpr double kSpacing = 1.0;      // [m] of a corrected path's points
constexpr double kFadeAfter = 6.0;    // [m] behind the place where the drive ended
constexpr double kFadeAtGoal = 4.0;   // [m], so that the goal stays where it is
constexpr double kLeastWorth = 0.05;  // [m]

/// Where the drive should go along: the path itself unless that is a correction.
const Path& Meant(const Candidate& candidate) {
  return candidate.meant.empty() ? candidate.path : candidate.meant;
}

bool SamePath(const Path& a, const Path& b) { return a.points() == b.points(); }

struct Deviation {
  double s;      // along the path that was meant
  double aside;  // [m] to the left of it
};

/// Of the vehicle's point that follows a path.
std::vector<Deviation> Deviations(const VehicleModel& vehicle, const Path& meant,
                                  const std::vector<TraceSample>& trace) {
  constexpr double kWindow = 3.0;  // [m] from one row to the next
  const double ahead = vehicle.path_point_x() - vehicle.bodies[0].p_RB.x();
  std::vector<Deviation> deviations;
  double s = 0;
  for (const TraceSample& row : trace) {
    const Eigen::Vector2d place(row.x + ahead * std::cos(row.yaw),
                                row.y + ahead * std::sin(row.yaw));
    s = meant.NearestArcLength(place, s, std::min(s + kWindow, meant.length()));
    const Eigen::Vector2d off = place - meant.Position(s);
    const double heading = meant.Heading(s);
    deviations.push_back({s, std::cos(heading) * off.y() - std::sin(heading) * off.x()});
  }
  return deviations;
}

double AsideAt(const std::vector<Deviation>& deviations, double s) {
  const auto next = std::lower_bound(deviations.begin(), deviations.end(), s,
                                     [](const Deviation& d, double at) { return d.s < at; });
  if (next == deviations.end()) {
    const Deviation& last = deviations.back();
    return last.aside * std::max(0.0, 1 - (s - last.s) / kFadeAfter);
  }
  if (next == deviations.begin()) return next->aside;
  const Deviation& before = *std::prev(next);
  const double share = (s - before.s) / std::max(next->s - before.s, 1e-9);
  return before.aside + share * (next->aside - before.aside);
}

/// Nothing where the drive was on its way.
std::optional<Candidate> Corrected(const VehicleModel& vehicle, const Candidate& parent,
                                   const Rollout& rollout) {
  if (rollout.trace.empty() || parent.path.reverse_length() > 0) return std::nullopt;
  const Path& meant = Meant(parent);
  const std::vector<Deviation> deviations = Deviations(vehicle, meant, rollout.trace);
  const int steps = std::max(1, static_cast<int>(std::ceil(meant.length() / kSpacing)));
  std::vector<Eigen::Vector2d> points;
  double largest = 0;
  for (int i = 0; i <= steps; ++i) {
    const double s = meant.length() * i / steps;
    const double fade = std::min(1.0, (meant.length() - s) / kFadeAtGoal);
    const double aside = i == 0 ? 0 : fade * AsideAt(deviations, s);
    const double heading = meant.Heading(s);
    const Eigen::Vector2d left(-std::sin(heading), std::cos(heading));
    const Eigen::Vector2d given = parent.meant.empty()
                                      ? meant.Position(s)
                                      : parent.path.points()[static_cast<std::size_t>(i)];
    points.push_back(given - aside * left);
    largest = std::max(largest, std::abs(aside));
  }
  if (largest < kLeastWorth) return std::nullopt;
  Candidate corrected = parent;
  corrected.origin = parent.origin.substr(0, parent.origin.find('+')) + "+corrected";
  corrected.meant = meant;
  corrected.path = Path(points);
  return corrected;
}

/// The last drive along each way, where it touched an obstacle; cheapest first.
std::vector<std::size_t> CollidedToCorrect(const DrivenCandidates& driven) {
  std::vector<const Path*> seen;
  std::vector<std::size_t> collided;
  for (std::size_t i = driven.candidates.size(); i-- > 0;) {
    const Path& meant = Meant(driven.candidates[i]);
    if (std::any_of(seen.begin(), seen.end(), [&](const Path* p) { return SamePath(*p, meant); })) {
      continue;
    }
    seen.push_back(&meant);
    if (driven.rollouts[i].outcome == Outcome::kCollided) collided.push_back(i);
  }
  std::stable_sort(collided.begin(), collided.end(), [&](std::size_t a, std::size_t b) {
    return driven.candidates[a].layer_cost < driven.candidates[b].layer_cost;
  });
  return collided;
}

}  // namespace

std::vector<Candidate> CorrectCollided(const VehicleModel& vehicle, const DrivenCandidates& driven,
                                       int most) {
  std::vector<Candidate> corrected;
  for (const std::size_t i : CollidedToCorrect(driven)) {
    if (static_cast<int>(corrected.size()) >= most) break;
    auto candidate = Corrected(vehicle, driven.candidates[i], driven.rollouts[i]);
    if (candidate) corrected.push_back(std::move(*candidate));
  }
  return corrected;
}

}  // namespace dbd
