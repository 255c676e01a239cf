#include "candidate_pool.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <utility>

namespace dbd {
namespace {

// Traces this near to each other are the same route found twice [m].
constexpr double kSameTrace = 0.01;

// Routes that cost more than this times the cheapest hardly ever win: they serve where there are
// no others.
constexpr double kWorthwhile = 2.0;

// A worthwhile variant this far off, as a share of the separation of different routes, serves
// better than a dear route.
constexpr double kVariant = 0.2;

// Separations are means, so a coarse trace serves.
constexpr double kTraceSpacing = 10.0;  // [m]

}  // namespace

CandidatePool::Entry::Entry(RouteDraft route)
    : draft(std::move(route)), trace(Thin(Positions(draft.poses), kTraceSpacing)) {}

void CandidatePool::Reserve(RouteDraft draft) {
  cheapest_ = std::min(cheapest_, draft.cost);
  reserve_.emplace_back(std::move(draft));
}

bool CandidatePool::IsWorthwhile(const Entry& entry) const {
  return entry.draft.cost <= kWorthwhile * cheapest_;
}

void CandidatePool::AddKnown(const std::vector<Candidate>& known) {
  for (const Candidate& candidate : known) {
    known_.push_back(Thin(candidate.path.points(), kTraceSpacing));
  }
}

bool CandidatePool::Offer(RouteDraft draft, double share) {
  const double least = share * min_separation_;
  cheapest_ = std::min(cheapest_, draft.cost);
  Entry entry(std::move(draft));
  bool taken = IsWorthwhile(entry);
  for (const std::vector<Eigen::Vector2d>& trace : known_) {
    taken = taken && SeparationUpTo(least, entry.trace, trace) >= least;
  }
  for (const Entry& other : taken_) {
    taken = taken && SeparationUpTo(least, entry.trace, other.trace) >= least;
  }
  (taken ? taken_ : reserve_).push_back(std::move(entry));
  return taken;
}

void CandidatePool::CompareReserveWith(std::size_t first_taken) {
  for (std::size_t i = first_taken; i < taken_.size(); ++i) CompareReserveWith(taken_[i].trace);
}

void CandidatePool::CompareReserveWith(const std::vector<Eigen::Vector2d>& trace) {
  for (Entry& waiting : reserve_) {
    ThrowIfStopped(stop_);
    waiting.separation = SeparationUpTo(waiting.separation, waiting.trace, trace);
  }
}

void CandidatePool::FillUp(int count) {
  if (size() < count) {
    for (const std::vector<Eigen::Vector2d>& trace : known_) CompareReserveWith(trace);
    CompareReserveWith(0);
  }
  for (const bool with_dear_ones : {false, true}) {
    while (size() < count && FillUpOnce(with_dear_ones)) CompareReserveWith(taken_.size() - 1);
  }
}

bool CandidatePool::FillUpOnce(bool with_dear_ones) {
  const double least =
      with_dear_ones ? kSameTrace : std::max(kSameTrace, kVariant * min_separation_);
  auto best = reserve_.end();
  for (auto entry = reserve_.begin(); entry != reserve_.end(); ++entry) {
    if (entry->separation < least || !(with_dear_ones || IsWorthwhile(*entry))) continue;
    if (best == reserve_.end() || entry->separation > best->separation) best = entry;
  }
  if (best == reserve_.end()) return false;
  Entry entry = std::move(*best);
  reserve_.erase(best);
  taken_.push_back(std::move(entry));
  return true;
}

std::vector<RouteDraft> CandidatePool::TakeSorted() {
  std::vector<RouteDraft> drafts;
  for (Entry& entry : taken_) drafts.push_back(std::move(entry.draft));
  taken_.clear();
  std::stable_sort(drafts.begin(), drafts.end(),
                   [](const RouteDraft& a, const RouteDraft& b) { return a.cost < b.cost; });
  return drafts;
}

}  // namespace dbd
