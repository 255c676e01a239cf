#include <dbd/planner/route_choice.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/success.h>

#include <algorithm>
#include <cstdio>

namespace dbd {
namespace {

std::string Format(const char* format, auto... values) {
  char text[320];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

/// Scores as they are when draws count: the expected cost, and feasible only where it succeeds
/// often enough.
std::vector<Score> WithSuccess(const Plan& plan, const UncertaintyOptions& uncertainty) {
  std::vector<Score> scores = plan.scores;
  for (std::size_t i = 0; i < plan.success.size(); ++i) {
    const std::optional<SuccessEstimate>& estimate = plan.success[i];
    scores[i].feasible =
        estimate && estimate->reached > 0 && estimate->share() >= uncertainty.min_success;
    if (estimate) scores[i].total = ExpectedCost(*estimate);
  }
  return scores;
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

std::string ExplainChoice(const Plan& plan, const std::vector<Score>& scores, int chosen) {
  const auto total = [&](int i) { return scores[static_cast<std::size_t>(i)].total; };
  const auto reached = std::count_if(plan.scores.begin(), plan.scores.end(),
                                     [](const Score& score) { return score.feasible; });
  std::string text =
      Format("candidate %d has the lowest %s, %.1f s, of %d that reached the goal (%d driven)",
             chosen, plan.success.empty() ? "score" : "expected cost", total(chosen),
             static_cast<int>(reached), static_cast<int>(plan.candidates.size()));
  if (const std::optional<int> next = BestFeasible(scores, chosen)) {
    text += Format("; the next best, candidate %d, scores %.1f s more", *next,
                   total(*next) - total(chosen));
  }
  return text;
}

std::string ExplainSuccess(const SuccessEstimate& estimate) {
  return Format(
      "reached the goal on %d of %d draws of the terrain (P(go) %.0f %%, 95 %% interval %.0f to "
      "%.0f %%)",
      estimate.reached, estimate.draws, 100 * estimate.p_go(), 100 * estimate.low,
      100 * estimate.high);
}

/// None of those driven on draws succeeds often enough: the one that comes nearest says why.
void ExplainTooRisky(Plan& plan, const UncertaintyOptions& uncertainty) {
  const auto share = [&](std::size_t i) {
    return plan.success[i] ? plan.success[i]->share() : -1.0;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < plan.success.size(); ++i) {
    if (share(i) > share(best)) best = i;
  }
  const SuccessEstimate& estimate = *plan.success[best];
  plan.blocked_at = estimate.failed_at;
  plan.reason = Format("no candidate succeeds on %.0f %% of the draws; the surest, candidate %zu, ",
                       100 * uncertainty.min_success, best) +
                ExplainSuccess(estimate) + "; it failed first by: " + estimate.failure;
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

void ChooseRoute(Plan& plan, const UncertaintyOptions& uncertainty,
                 std::optional<PlanStatus> stopped) {
  const std::vector<Score> scores = WithSuccess(plan, uncertainty);
  plan.chosen = BestFeasible(scores, std::nullopt);
  if (plan.chosen) {
    plan.status = stopped.value_or(PlanStatus::kRoute);
    plan.reason = (stopped ? ExplainStop(*stopped) + ": best so far, " : "") +
                  ExplainChoice(plan, scores, *plan.chosen);
    if (!plan.success.empty()) {
      plan.reason +=
          "; it " + ExplainSuccess(*plan.success[static_cast<std::size_t>(*plan.chosen)]);
    }
  } else if (stopped) {
    plan.status = *stopped;
    plan.reason = ExplainStop(*stopped) + " before a candidate reached the goal";
  } else if (!plan.success.empty()) {
    plan.status = PlanStatus::kNoGo;
    ExplainTooRisky(plan, uncertainty);
  } else {
    plan.status = PlanStatus::kNoGo;
    ExplainNoGo(plan);
  }
}

}  // namespace dbd
