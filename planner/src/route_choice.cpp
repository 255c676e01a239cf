#include <dbd/planner/route_choice.h>
#include <dbd/planner/scoring.h>

#include <algorithm>
#include <cstdio>

namespace dbd {
namespace {

std::string Format(const char* format, auto... values) {
  char text[320];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

std::optional<int> BestFeasible(const std::vector<Score>& scores, std::optional<int> except) {
  std::optional<int> best;
  for (int i = 0; i < static_cast<int>(scores.size()); ++i) {
    const Score& score = scores[static_cast<std::size_t>(i)];
    if (!score.feasible || except == i) continue;
    if (!best || score.total < scores[static_cast<std::size_t>(*best)].total) best = i;
  }
  return best;
}

std::string ExplainChoice(const Plan& plan, int chosen) {
  const auto total = [&](int i) { return plan.scores[static_cast<std::size_t>(i)].total; };
  const auto reached = std::count_if(plan.scores.begin(), plan.scores.end(),
                                     [](const Score& score) { return score.feasible; });
  std::string text = Format(
      "candidate %d has the lowest score, %.1f s, of %d that reached the goal (%d driven)", chosen,
      total(chosen), static_cast<int>(reached), static_cast<int>(plan.candidates.size()));
  if (const std::optional<int> next = BestFeasible(plan.scores, chosen)) {
    text += Format("; the next best, candidate %d, scores %.1f s more", *next,
                   total(*next) - total(chosen));
  }
  return text;
}

/// The drive that came farthest says most about what is in the way.
int FarthestRollout(const std::vector<Rollout>& rollouts) {
  const auto farthest =
      std::max_element(rollouts.begin(), rollouts.end(),
                       [](const auto& a, const auto& b) { return a.progress < b.progress; });
  return static_cast<int>(farthest - rollouts.begin());
}

std::string CountOutcomes(const std::vector<Rollout>& rollouts) {
  std::map<Outcome, int> counts;
  for (const Rollout& rollout : rollouts) ++counts[rollout.outcome];
  std::string text;
  for (const auto& [outcome, count] : counts) {
    text += (text.empty() ? "" : ", ") + Format("%d %s", count, OutcomeName(outcome));
  }
  return text;
}

void ExplainNoGo(Plan& plan) {
  const int farthest = FarthestRollout(plan.rollouts);
  const Rollout& rollout = plan.rollouts[static_cast<std::size_t>(farthest)];
  plan.blocked_at = rollout.place;
  plan.reason = Format("none of %d driven candidates reached the goal (",
                       static_cast<int>(plan.rollouts.size())) +
                CountOutcomes(plan.rollouts) +
                Format("); candidate %d came farthest, %.0f %% of its way: ", farthest,
                       100 * rollout.progress) +
                rollout.reason;
}

std::string ExplainStop(PlanStatus stopped) {
  return stopped == PlanStatus::kDeadline ? "the deadline passed" : "cancelled";
}

}  // namespace

void ChooseRoute(Plan& plan, std::optional<PlanStatus> stopped) {
  plan.chosen = BestFeasible(plan.scores, std::nullopt);
  if (plan.chosen) {
    plan.status = stopped.value_or(PlanStatus::kRoute);
    plan.reason = (stopped ? ExplainStop(*stopped) + ": best so far, " : "") +
                  ExplainChoice(plan, *plan.chosen);
  } else if (stopped) {
    plan.status = *stopped;
    plan.reason = ExplainStop(*stopped) + " before a candidate reached the goal";
  } else {
    plan.status = PlanStatus::kNoGo;
    ExplainNoGo(plan);
  }
}

}  // namespace dbd
