#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <optional>
#include <stop_token>
#include <vector>

namespace dbd {

struct Interval {
  double low = 0;
  double high = 1;
};

/// 95 % interval of a probability after so many successes: E. B. Wilson, "Probable inference, the
/// law of succession, and statistical inference", 1927. [0, 1] without trials.
Interval WilsonInterval(int successes, int trials);

/// Mean of the largest values: `share` of them, rounded up to at least one. Zero without values.
double MeanOfLargest(std::vector<double> values, double share);

/// Cost of a route that may fail: the mean score of the drives that arrive over P(go), as if a
/// failure cost another try. Infinite when none arrives.
double ExpectedCost(const SuccessEstimate& estimate);

/// Drives the best few of the candidates that reached the goal on draws of the terrain, all of them
/// on the same draws (common random numbers: what differs is the route, not its luck). Ends before
/// `options.uncertainty.draws` when the ranking is settled: the best candidate's interval lies on
/// one side of the wanted success, and it beats every other that may reach it by two standard
/// errors of their paired difference, on 16 draws at least. One entry per candidate; nothing for
/// those not driven.
///
/// The same for any number of threads. Throws StopRequested soon after `stop` was asked to.
std::vector<std::optional<SuccessEstimate>> EstimateSuccess(
    const Terrain& terrain, const VehicleModel& vehicle, const std::vector<Candidate>& candidates,
    const std::vector<Score>& scores, const PlanOptions& options, const RolloutCallback& on_done,
    std::stop_token stop);

}  // namespace dbd
