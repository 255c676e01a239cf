#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/plan_route.h>
#include <dbd/planner/route_choice.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/trafficability.h>

#include <chrono>

#include "digest.h"

namespace dbd {
namespace {

/// Seconds since the last call, under the name of the stage that they were spent in.
class StageClock {
 public:
  explicit StageClock(Plan& plan) : plan_(plan), last_(Clock::now()) {}

  void Finish(const std::string& stage) {
    const Clock::time_point now = Clock::now();
    plan_.timing.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Plan& plan_;
  Clock::time_point last_;
};

void AnswerWithDiagnosis(const Terrain& terrain, const NoRouteDiagnosis& diagnosis, Plan& plan) {
  plan.status = PlanStatus::kNoGo;
  plan.reason = diagnosis.why;
  const double x = diagnosis.where.x(), y = diagnosis.where.y();
  plan.blocked_at = Eigen::Vector3d(x, y, terrain.Height(x, y));
}

}  // namespace

Plan PlanRoute(std::shared_ptr<const Terrain> terrain, std::shared_ptr<const VehicleModel> vehicle,
               const PlanRequest& request, const PlanOptions& options,
               const ProgressCallback& progress, std::stop_token stop) {
  options.Validate();
  Plan plan;
  StageClock clock(plan);
  const TrafficabilityLayer layer(*terrain, *vehicle, options.max_speed);
  clock.Finish("trafficability");

  CandidateSet sampled = SampleCandidates(*terrain, *vehicle, layer, request, options, progress);
  plan.candidates = std::move(sampled.candidates);
  clock.Finish("candidates");
  if (plan.candidates.empty()) {
    AnswerWithDiagnosis(*terrain, sampled.diagnosis.value_or(NoRouteDiagnosis{}), plan);
    plan.digest = DigestOf(plan);
    return plan;
  }

  plan.rollouts = EvaluateRollouts(*terrain, *vehicle, plan.candidates, options, progress, stop);
  for (const Rollout& rollout : plan.rollouts) plan.simulated_time += rollout.time;
  clock.Finish("rollouts");

  plan.scores = ScoreRollouts(plan.rollouts, options.scoring);
  ChooseRoute(plan);
  clock.Finish("choice");
  plan.digest = DigestOf(plan);
  return plan;
}

}  // namespace dbd
