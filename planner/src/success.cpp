#include <dbd/planner/scoring.h>
#include <dbd/planner/stop.h>
#include <dbd/planner/success.h>
#include <dbd/planner/terrain_draw.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "candidate_random.h"
#include "work_arena.h"

namespace dbd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNormal95 = 1.959963984540054;  // two-sided 95 %
constexpr double kTail = 0.1;
constexpr int kDrawsAtOnce = 8;   // between looks at the ranking, whatever the number of threads
constexpr int kFewestDraws = 16;  // a share of fewer says too little of P(go), settled or not
constexpr std::uint64_t kDrawStream = 0x6472617773;  // apart from the planner's other streams

/// Rollouts of the survivors on all draws so far: [draw][survivor].
using Drives = std::vector<std::vector<Rollout>>;

/// Indices of the candidates with the lowest scores, in the order of the scores.
std::vector<std::size_t> Survivors(const std::vector<Score>& scores, int most) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (scores[i].feasible) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a].total < scores[b].total; });
  order.resize(std::min(order.size(), static_cast<std::size_t>(most)));
  return order;
}

SuccessEstimate Summarize(const Drives& drives, std::size_t survivor,
                          const ScoringOptions& scoring) {
  SuccessEstimate estimate;
  std::vector<double> times;
  double score = 0;
  for (const std::vector<Rollout>& draw : drives) {
    const Rollout& rollout = draw[survivor];
    ++estimate.draws;
    if (rollout.outcome == Outcome::kReached) {
      ++estimate.reached;
      times.push_back(rollout.time);
      score += ScoreRollout(rollout, scoring).total;
    } else if (estimate.failure.empty()) {
      estimate.failure = rollout.reason;
      estimate.failed_at = rollout.place;
    }
  }
  const Interval interval = WilsonInterval(estimate.reached, estimate.draws);
  estimate.low = interval.low, estimate.high = interval.high;
  if (times.empty()) return estimate;
  const auto count = static_cast<double>(times.size());
  estimate.mean_time = std::accumulate(times.begin(), times.end(), 0.0) / count;
  estimate.mean_score = score / count;
  estimate.cvar_time = MeanOfLargest(times, kTail);
  return estimate;
}

/// Whether survivor `a` scores lower than `b` by two standard errors of the difference over the
/// draws on which both arrived.
bool Beats(const Drives& drives, std::size_t a, std::size_t b, const ScoringOptions& scoring) {
  double sum = 0, squares = 0;
  int count = 0;
  for (const std::vector<Rollout>& draw : drives) {
    const double difference =
        ScoreRollout(draw[b], scoring).total - ScoreRollout(draw[a], scoring).total;
    if (!std::isfinite(difference)) continue;
    sum += difference, squares += difference * difference, ++count;
  }
  if (count < 2) return false;
  const double mean = sum / count;
  const double variance = std::max(0.0, squares - sum * mean) / (count - 1);
  return mean > 2 * std::sqrt(variance / count);
}

bool IsSettled(const Drives& drives, const std::vector<SuccessEstimate>& estimates,
               const PlanOptions& options) {
  const double wanted = options.uncertainty.min_success;
  const auto may_do = [wanted](const SuccessEstimate& e) { return e.high >= wanted; };
  if (std::none_of(estimates.begin(), estimates.end(), may_do)) return true;
  const std::size_t best = static_cast<std::size_t>(
      std::min_element(estimates.begin(), estimates.end(),
                       [&](const SuccessEstimate& a, const SuccessEstimate& b) {
                         if (may_do(a) != may_do(b)) return may_do(a);
                         return ExpectedCost(a) < ExpectedCost(b);
                       }) -
      estimates.begin());
  if (estimates[best].low < wanted) return false;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    if (i == best || !may_do(estimates[i])) continue;
    if (!Beats(drives, best, i, options.scoring)) return false;
  }
  return true;
}

}  // namespace

Interval WilsonInterval(int successes, int trials) {
  if (trials == 0) return {};
  const double n = trials, p = successes / n, zz = kNormal95 * kNormal95;
  const double center = (p + zz / (2 * n)) / (1 + zz / n);
  const double half = kNormal95 / (1 + zz / n) * std::sqrt(p * (1 - p) / n + zz / (4 * n * n));
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

double MeanOfLargest(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end(), std::greater<>());
  const auto kept = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))));
  values.resize(std::min(kept, values.size()));
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double ExpectedCost(const SuccessEstimate& estimate) {
  return estimate.reached > 0 ? estimate.mean_score / estimate.p_go() : kInfinity;
}

std::vector<std::optional<SuccessEstimate>> EstimateSuccess(
    const Terrain& terrain, const VehicleModel& vehicle, const std::vector<Candidate>& candidates,
    const std::vector<Score>& scores, const PlanOptions& options, const RolloutCallback& on_done,
    std::stop_token stop) {
  const std::vector<std::size_t> survivors = Survivors(scores, options.uncertainty.survivors);
  std::vector<Candidate> driven;
  for (const std::size_t i : survivors) driven.push_back(candidates[i]);
  PlanOptions alone = options;
  alone.threads = 1;
  std::mutex report_mutex;
  const auto report = [&](const Rollout& rollout) {
    const std::lock_guard lock(report_mutex);
    if (on_done) on_done(rollout);
  };
  Drives drives;
  std::vector<SuccessEstimate> estimates;
  WorkArena arena(options.threads);
  const std::uint64_t seed = DeriveSeed(options.seed, kDrawStream);
  while (!driven.empty() && static_cast<int>(drives.size()) < options.uncertainty.draws) {
    const int first = static_cast<int>(drives.size());
    const int last = std::min(first + kDrawsAtOnce, options.uncertainty.draws);
    drives.resize(static_cast<std::size_t>(last));
    arena.Execute([&] {
      tbb::parallel_for(first, last, [&](int draw) {
        const Terrain drawn = DrawTerrain(terrain, options.uncertainty.spread, seed, draw, stop);
        drives[static_cast<std::size_t>(draw)] =
            EvaluateRollouts(drawn, vehicle, driven, alone, report, stop);
      });
    });
    ThrowIfStopped(stop);
    estimates.clear();
    for (std::size_t i = 0; i < driven.size(); ++i) {
      estimates.push_back(Summarize(drives, i, options.scoring));
    }
    if (last >= kFewestDraws && IsSettled(drives, estimates, options)) break;
  }
  std::vector<std::optional<SuccessEstimate>> all(candidates.size());
  for (std::size_t i = 0; i < estimates.size(); ++i) all[survivors[i]] = estimates[i];
  return all;
}

}  // namespace dbd
