#include "candidate_pool.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <utility>

namespace dbd {
namespace {

// Traces this near to each other are the same route found twice [m].
constexpr double kSameTrace = 0.01;

// Separations are means, so a coarse trace serves.
constexpr double kTraceSpacing = 10.0;  // [m]

}  // namespace

CandidatePool::Entry::Entry(RouteDraft route)
    : draft(std::move(route)), trace(Thin(Positions(draft.poses), kTraceSpacing)) {}

void CandidatePool::Reserve(RouteDraft draft) { reserve_.emplace_back(std::move(draft)); }

void CandidatePool::AddKnown(const std::vector<Candidate>& known) {
  for (const Candidate& candidate : known) {
    known_.push_back(Thin(candidate.path.points(), kTraceSpacing));
  }
}

bool CandidatePool::Offer(RouteDraft draft) {
  Entry entry(std::move(draft));
  for (const std::vector<Eigen::Vector2d>& trace : known_) {
    if (Separation(entry.trace, trace) >= min_separation_) continue;
    reserve_.push_back(std::move(entry));
    return false;
  }
  for (const Entry& other : taken_) {
    if (Separation(entry.trace, other.trace) >= min_separation_) continue;
    reserve_.push_back(std::move(entry));
    return false;
  }
  taken_.push_back(std::move(entry));
  return true;
}

void CandidatePool::CompareReserveWith(std::size_t first_taken) {
  for (std::size_t i = first_taken; i < taken_.size(); ++i) CompareReserveWith(taken_[i].trace);
}

void CandidatePool::CompareReserveWith(const std::vector<Eigen::Vector2d>& trace) {
  for (Entry& waiting : reserve_) {
    ThrowIfStopped(stop_);
    waiting.separation = std::min(waiting.separation, Separation(waiting.trace, trace));
  }
}

void CandidatePool::FillUp(int count) {
  if (size() < count) {
    for (const std::vector<Eigen::Vector2d>& trace : known_) CompareReserveWith(trace);
    CompareReserveWith(0);
  }
  while (size() < count && !reserve_.empty()) {
    const auto best = std::max_element(
        reserve_.begin(), reserve_.end(),
        [](const Entry& a, const Entry& b) { return a.separation < b.separation; });
    if (best->separation < kSameTrace) return;
    Entry entry = std::move(*best);
    reserve_.erase(best);
    taken_.push_back(std::move(entry));
    CompareReserveWith(taken_.size() - 1);
  }
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
