#include <dbd/planner/batch_evaluation.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

/// 120 m x 60 m of gentle waves with a bank in the north that is too steep to climb.
Terrain WavesWithABank() {
  return SurfaceTerrain(121, 61, 1, [](double x, double y) {
    return 0.3 * std::sin(0.25 * x) + (y > 45 ? 1.2 * (y - 45) : 0.0);
  });
}

/// Straight lines to the east and to the north-east: some reach their end, some meet the bank.
std::vector<Candidate> Fan(int count) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < count; ++i) {
    const double y = 10 + 3.0 * i;
    const double climb = i % 3 == 2 ? 30 : 2;
    candidates.push_back({"test", Path({{10, y}, {35.0 + 3 * (i % 5), y + climb}}), 0});
  }
  return candidates;
}

std::vector<Rollout> Evaluate(const std::vector<Candidate>& candidates, RolloutEngine engine,
                              int threads, std::stop_token stop = {}) {
  static const Terrain terrain = WavesWithABank();
  static const auto vehicle = LoadVehicle("tomcar-tm27");
  PlanOptions options;
  options.engine = engine;
  options.threads = threads;
  return EvaluateRollouts(terrain, *vehicle, candidates, options, {}, stop);
}

void ExpectSameBits(const Rollout& a, const Rollout& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_EQ(a.place, b.place);
  ASSERT_EQ(a.trace.size(), b.trace.size());
  for (std::size_t i = 0; i < a.trace.size(); ++i) {
    EXPECT_EQ(a.trace[i].z, b.trace[i].z);
    EXPECT_EQ(a.trace[i].roll, b.trace[i].roll);
    EXPECT_EQ(a.trace[i].slip, b.trace[i].slip);
  }
}

TEST(EvaluateRollouts, ThreadsChangeNoBit) {
  const std::vector<Candidate> candidates = Fan(10);
  const std::vector<Rollout> one = Evaluate(candidates, RolloutEngine::kLanes, 1);
  for (const int threads : {2, 3}) {
    const std::vector<Rollout> more = Evaluate(candidates, RolloutEngine::kLanes, threads);
    for (std::size_t i = 0; i < one.size(); ++i) ExpectSameBits(one[i], more[i]);
  }
}

TEST(EvaluateRollouts, ACandidateDrivesTheSameAmongOthersAndAlone) {
  const std::vector<Candidate> candidates = Fan(10);
  const std::vector<Rollout> together = Evaluate(candidates, RolloutEngine::kLanes, 2);
  for (const std::size_t i : {0, 2, 9}) {
    const std::vector<Rollout> alone = Evaluate({candidates[i]}, RolloutEngine::kLanes, 1);
    ExpectSameBits(alone[0], together[i]);
  }
}

TEST(EvaluateRollouts, LanesAndReferenceAgreeOnEveryOutcome) {
  const std::vector<Candidate> candidates = Fan(10);
  const std::vector<Rollout> lanes = Evaluate(candidates, RolloutEngine::kLanes, 1);
  const std::vector<Rollout> reference = Evaluate(candidates, RolloutEngine::kReference, 1);
  int reached = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    EXPECT_EQ(lanes[i].outcome, reference[i].outcome) << i;
    EXPECT_NEAR(lanes[i].time, reference[i].time, 0.021) << i;  // half a look
    EXPECT_LT((lanes[i].place - reference[i].place).norm(), 0.1) << i;
    reached += lanes[i].outcome == Outcome::kReached;
  }
  EXPECT_GT(reached, 2);
  EXPECT_LT(reached, 10);
}

TEST(EvaluateRollouts, StopEndsEveryDriveAsCancelled) {
  std::stop_source source;
  source.request_stop();
  for (const RolloutEngine engine : {RolloutEngine::kLanes, RolloutEngine::kReference}) {
    const auto rollouts = Evaluate(Fan(3), engine, 1, source.get_token());
    for (const Rollout& rollout : rollouts) EXPECT_EQ(rollout.outcome, Outcome::kCancelled);
  }
}

TEST(EvaluateRollouts, ReportsEveryDriveOnce) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain terrain = WavesWithABank();
  std::multiset<double> seen, returned;
  const auto on_done = [&seen](const Rollout& rollout) { seen.insert(rollout.time); };
  for (const Rollout& rollout : EvaluateRollouts(terrain, *vehicle, Fan(6), {}, on_done, {})) {
    returned.insert(rollout.time);
  }
  EXPECT_EQ(seen, returned);
  EXPECT_EQ(seen.size(), 6u);
}

}  // namespace
}  // namespace dbd
