#include <dbd/planner/scoring.h>

#include <algorithm>

namespace dbd {

const LimitMargin* TightestLimit(const Rollout& rollout) {
  const auto tightest =
      std::min_element(rollout.margins.begin(), rollout.margins.end(),
                       [](const auto& a, const auto& b) { return a.margin < b.margin; });
  return tightest == rollout.margins.end() ? nullptr : &*tightest;
}

double TimeCost(const Rollout& rollout) { return rollout.time; }

double EnergyCost(const Rollout& rollout, const ScoringOptions& options) {
  return options.energy_weight * rollout.energy;
}

double RiskCost(const Rollout& rollout, const ScoringOptions& options) {
  const LimitMargin* tightest = TightestLimit(rollout);
  const double used = tightest == nullptr ? 0 : 1 - std::clamp(tightest->margin, 0.0, 1.0);
  return options.risk_weight * used * used;
}

Score ScoreRollout(const Rollout& rollout, const ScoringOptions& options) {
  Score score;
  score.feasible = rollout.outcome == Outcome::kReached;
  score.terms = {{"time", TimeCost(rollout)},
                 {"energy", EnergyCost(rollout, options)},
                 {"risk", RiskCost(rollout, options)}};
  if (!score.feasible) return score;
  score.total = 0;
  for (const auto& [name, value] : score.terms) score.total += value;
  return score;
}

std::vector<Score> ScoreRollouts(const std::vector<Rollout>& rollouts,
                                 const ScoringOptions& options) {
  std::vector<Score> scores;
  for (const Rollout& rollout : rollouts) scores.push_back(ScoreRollout(rollout, options));
  return scores;
}

}  // namespace dbd
