#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/plan_route.h>
#include <dbd/planner/route_choice.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/trafficability.h>

#include <chrono>

#include "deadline.h"
#include "digest.h"

namespace dbd {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Seconds since the last call, under the name of the stage that they were spent in.
class StageClock {
 public:
  explicit StageClock(Plan& plan) : plan_(plan), last_(Clock::now()) {}

  void Finish(const std::string& stage) {
    plan_.timing.emplace_back(stage, SecondsSince(last_));
    last_ = Clock::now();
  }

 private:
  Plan& plan_;
  Clock::time_point last_;
};

void AnswerWithDiagnosis(const Terrain& terrain, const NoRouteDiagnosis& diagnosis, Plan& plan) {
  plan.status = PlanStatus::kNoGo;
  plan.reason = diagnosis.why;
  const double x = diagnosis.where.x(), y = diagnosis.where.y();
  plan.blocked_at = Eigen::Vector3d(x, y, terrain.Height(x, y));
}

/// The stages of one request, each from the value of the one before.
class Planning {
 public:
  Planning(const Terrain& terrain, const VehicleModel& vehicle, const PlanRequest& request,
           const PlanOptions& options, const ProgressCallback& progress, std::stop_token stop)
      : terrain_(terrain),
        vehicle_(vehicle),
        request_(request),
        options_(options),
        progress_(progress),
        stop_(std::move(stop)) {}

  /// Throws StopRequested soon after the stop was asked for; `plan` then holds what is done so far.
  void Run(Plan& plan) {
    StageClock clock(plan);
    const TrafficabilityLayer layer(terrain_, vehicle_, options_.max_speed, {}, stop_);
    clock.Finish("trafficability");
    CandidateSet sampled =
        SampleCandidates(terrain_, vehicle_, layer, request_, options_, progress_, stop_);
    clock.Finish("candidates");
    if (sampled.candidates.empty()) {
      AnswerWithDiagnosis(terrain_, sampled.diagnosis.value_or(NoRouteDiagnosis{}), plan);
      return;
    }
    Drive(std::move(sampled.candidates), plan);
    clock.Finish("rollouts");
    ThrowIfCancelled(plan.rollouts);
    ChooseRoute(plan);
  }

 private:
  static void ThrowIfCancelled(const std::vector<Rollout>& rollouts) {
    for (const Rollout& rollout : rollouts) {
      if (rollout.outcome == Outcome::kCancelled) throw StopRequested();
    }
  }

  void Drive(std::vector<Candidate> candidates, Plan& plan) {
    plan.candidates = std::move(candidates);
    const int total = static_cast<int>(plan.candidates.size());
    int done = 0;
    const auto on_done = [&](const Rollout& rollout) {
      if (rollout.outcome == Outcome::kReached && !plan.first_route_time) {
        plan.first_route_time = SecondsSince(begin_);
      }
      if (progress_) progress_("drive", ++done, total);
    };
    plan.rollouts = EvaluateRollouts(terrain_, vehicle_, plan.candidates, options_, on_done, stop_);
    plan.scores = ScoreRollouts(plan.rollouts, options_.scoring);
    for (const Rollout& rollout : plan.rollouts) plan.simulated_time += rollout.time;
  }

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  const PlanRequest& request_;
  const PlanOptions& options_;
  const ProgressCallback& progress_;
  std::stop_token stop_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

Plan PlanRoute(std::shared_ptr<const Terrain> terrain, std::shared_ptr<const VehicleModel> vehicle,
               const PlanRequest& request, const PlanOptions& options,
               const ProgressCallback& progress, std::stop_token stop) {
  options.Validate();
  const Deadline deadline(options.deadline, stop);
  Plan plan;
  try {
    Planning(*terrain, *vehicle, request, options, progress, deadline.token()).Run(plan);
  } catch (const StopRequested&) {
    ChooseRoute(plan, deadline.passed() ? PlanStatus::kDeadline : PlanStatus::kCancelled);
  }
  plan.digest = DigestOf(plan);
  return plan;
}

}  // namespace dbd
