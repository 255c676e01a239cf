#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/layer_cache.h>
#include <dbd/planner/lessons.h>
#include <dbd/planner/plan_route.h>
#include <dbd/planner/route_choice.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/success.h>
#include <dbd/planner/trafficability.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "candidate_correction.h"
#include "candidate_random.h"
#include "candidate_variants.h"
#include "deadline.h"
#include "digest.h"
#include "plan_budget.h"
#include "speed_limits.h"
#include "stage_clock.h"
#include "work_arena.h"

namespace dbd {
namespace {

void AnswerWithDiagnosis(const Terrain& terrain, const NoRouteDiagnosis& diagnosis, Plan& plan) {
  plan.status = PlanStatus::kNoGo;
  plan.reason = diagnosis.why;
  const double x = diagnosis.where.x(), y = diagnosis.where.y();
  plan.blocked_at = Eigen::Vector3d(x, y, terrain.Height(x, y));
}

/// What is asked of the search after the first round, which looks for few routes only.
SamplingOptions Coarser(SamplingOptions sampling) {
  sampling.roadmap_nodes = std::max(10, sampling.roadmap_nodes / 2);
  sampling.planner_iterations = std::max(1, sampling.planner_iterations / 2);
  return sampling;
}

bool NoneReached(const Plan& plan) {
  return std::none_of(plan.scores.begin(), plan.scores.end(),
                      [](const Score& score) { return score.feasible; });
}

/// The stages of one request, each from the value of the one before, in rounds.
class Planning {
 public:
  Planning(const Terrain& terrain, const VehicleModel& vehicle, const PlanRequest& request,
           const PlanOptions& options, const ProgressCallback& progress, std::stop_token stop)
      : terrain_(terrain),
        vehicle_(vehicle),
        request_(request),
        options_(options),
        progress_(progress),
        stop_(std::move(stop)),
        budget_(options) {}

  /// Throws StopRequested soon after the stop was asked for; `plan` then holds what is done so far.
  void Run(const TrafficabilityLayer& layer, Plan& plan, StageClock& clock) {
    CandidateSet sampled = Sample(layer, budget_.first, plan);
    clock.Finish("candidates");
    if (sampled.candidates.empty()) {
      AnswerWithDiagnosis(terrain_, sampled.diagnosis.value_or(NoRouteDiagnosis{}), plan);
      return;
    }
    Drive("sample", std::move(sampled.candidates), plan, clock);
    Learn(layer, plan, clock);
    DriveOnDraws(plan, clock);
    ChooseRoute(plan, options_.uncertainty);
    clock.Finish("choice");
  }

 private:
  int Left(const Plan& plan) const {
    return budget_.all - static_cast<int>(plan.candidates.size());
  }

  /// A seed of its own for each round.
  std::uint64_t RoundSeed(const Plan& plan) const {
    return plan.rounds.empty() ? options_.seed : DeriveSeed(options_.seed, plan.rounds.size());
  }

  /// Each later round drives new routes, which avoid what was met, and variants of the best, side
  /// by side: what a round costs is its slowest drive, however many fill the lanes beside it.
  void Learn(const TrafficabilityLayer& layer, Plan& plan, StageClock& clock) {
    for (int left = options_.learning.rounds - 1; left > 0 && Left(plan) > 0; --left) {
      const int count = (Left(plan) + left - 1) / left;
      const TrafficabilityLayer learned = layer.WithExtraCost(std::make_shared<const ExtraCost>(
          LearnFromRollouts(layer, plan.rollouts, options_.scoring)));
      std::vector<Candidate> next = Sample(learned, count, plan).candidates;
      const DrivenCandidates driven{plan.candidates, plan.rollouts, plan.scores};
      const std::vector<Candidate> corrected =
          CorrectCollided(vehicle_, driven, NoneReached(plan) ? count / 2 : count / 4);
      const int others = count - static_cast<int>(corrected.size());
      const std::vector<Candidate> variants =
          VaryBest(learned, vehicle_, driven,
                   std::max(budget_.Variants(others), others - static_cast<int>(next.size())),
                   RoundSeed(plan));
      next.resize(std::min(next.size(), static_cast<std::size_t>(others) - variants.size()));
      next.insert(next.end(), variants.begin(), variants.end());
      if (NoneReached(plan)) DriveWithCare(next);
      next.insert(next.end(), corrected.begin(), corrected.end());
      clock.Finish("candidates");
      if (!next.empty()) Drive("learn", std::move(next), plan, clock);
    }
  }

  /// What no drive got through at the usual speed may be passed at a walking pace: every other one
  /// tries.
  void DriveWithCare(std::vector<Candidate>& candidates) const {
    for (std::size_t i = 0; i < candidates.size(); i += 2) {
      Candidate& candidate = candidates[i];
      const std::vector<SpeedCap> caps = CapsBesideObstacles(terrain_, vehicle_, candidate.path);
      if (!caps.empty()) candidate.origin += "+careful";
      candidate.speed_caps.insert(candidate.speed_caps.end(), caps.begin(), caps.end());
    }
  }

  /// Nothing when nothing is drawn or nobody arrived.
  void DriveOnDraws(Plan& plan, StageClock& clock) const {
    const UncertaintyOptions& uncertainty = options_.uncertainty;
    const auto feasible = std::count_if(plan.scores.begin(), plan.scores.end(),
                                        [](const Score& score) { return score.feasible; });
    if (uncertainty.draws <= 1 || feasible == 0) return;
    const int total =
        uncertainty.draws * std::min(uncertainty.survivors, static_cast<int>(feasible));
    int done = 0;
    double simulated_time = 0;
    const auto on_done = [&](const Rollout& rollout) {
      simulated_time += rollout.time;
      if (progress_) progress_("draws", ++done, total);
    };
    plan.success =
        EstimateSuccess(terrain_, vehicle_, plan.candidates, plan.scores, options_, on_done, stop_);
    plan.simulated_time += simulated_time;
    clock.Finish("draws");
  }

  CandidateSet Sample(const TrafficabilityLayer& layer, int count, const Plan& plan) const {
    PlanOptions options = options_;
    options.sampling.candidates = count;
    options.seed = RoundSeed(plan);
    if (!plan.rounds.empty()) {
      options.sampling = Coarser(options.sampling);
      options.sampling.narrow_ways |= NoneReached(plan);
    }
    if (count == 0) return {};
    return SampleCandidates(terrain_, vehicle_, layer, request_, options, progress_, stop_,
                            plan.candidates);
  }

  void Drive(const char* name, std::vector<Candidate> candidates, Plan& plan, StageClock& clock) {
    const auto on_done = [&](const Rollout& rollout) {
      if (rollout.outcome == Outcome::kReached && !plan.first_route_time) {
        plan.first_route_time = SecondsSince(begin_);
      }
      if (progress_) progress_("drive", ++driven_, budget_.all);
    };
    const std::vector<Rollout> rollouts =
        EvaluateRollouts(terrain_, vehicle_, candidates, options_, on_done, stop_);
    Append(name, std::move(candidates), rollouts, plan);
    clock.Finish("rollouts");
    for (const Rollout& rollout : rollouts) {
      if (rollout.outcome == Outcome::kCancelled) throw StopRequested();
    }
  }

  void Append(const char* name, std::vector<Candidate> candidates,
              const std::vector<Rollout>& rollouts, Plan& plan) const {
    PlanRound round{name, static_cast<int>(candidates.size()), 0};
    if (!plan.rounds.empty()) round.best_score = plan.rounds.back().best_score;
    std::move(candidates.begin(), candidates.end(), std::back_inserter(plan.candidates));
    for (const Rollout& rollout : rollouts) {
      plan.rollouts.push_back(rollout);
      plan.scores.push_back(ScoreRollout(rollout, options_.scoring));
      plan.simulated_time += rollout.time;
      round.reached += rollout.outcome == Outcome::kReached;
      round.best_score = std::min(round.best_score, plan.scores.back().total);
    }
    plan.rounds.push_back(round);
  }

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  const PlanRequest& request_;
  const PlanOptions& options_;
  const ProgressCallback& progress_;
  std::stop_token stop_;
  Budget budget_;
  int driven_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

Plan PlanRoute(std::shared_ptr<const Terrain> terrain, std::shared_ptr<const VehicleModel> vehicle,
               const PlanRequest& request, const PlanOptions& options,
               const ProgressCallback& progress, std::stop_token stop, LayerCache* layers) {
  options.Validate();
  const Deadline deadline(options.deadline, stop);
  Plan plan;
  try {
    Planning planning(*terrain, *vehicle, request, options, progress, deadline.token());
    StageClock clock(plan);
    LayerCache own(0);
    std::shared_ptr<const TrafficabilityLayer> layer;
    WorkArena(options.threads).Execute([&] {
      layer = (layers ? *layers : own).Get(terrain, vehicle, options.max_speed, deadline.token());
    });
    clock.Finish("trafficability");
    planning.Run(*layer, plan, clock);
  } catch (const StopRequested&) {
    ChooseRoute(plan, options.uncertainty,
                deadline.passed() ? PlanStatus::kDeadline : PlanStatus::kCancelled);
  }
  plan.digest = DigestOf(plan);
  return plan;
}

}  // namespace dbd
