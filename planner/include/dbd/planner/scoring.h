#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

// Criteria, each a pure function of one rollout, in seconds: lower is better.

/// Driving time.
double TimeCost(const Rollout& rollout);

/// Work at the driven wheels, at the price the options put on it.
double EnergyCost(const Rollout& rollout, const ScoringOptions& options);

/// Grows from nothing at full margins to `risk_weight` where a margin is used up: the square of
/// the used share of the tightest limit.
double RiskCost(const Rollout& rollout, const ScoringOptions& options);

/// Constraints first: only a rollout that reached the goal is feasible; then the weighted sum.
Score ScoreRollout(const Rollout& rollout, const ScoringOptions& options);

std::vector<Score> ScoreRollouts(const std::vector<Rollout>& rollouts,
                                 const ScoringOptions& options);

/// The limit with the least margin; null when there are none.
const LimitMargin* TightestLimit(const Rollout& rollout);

}  // namespace dbd
