#include <dbd/core/error.h>
#include <dbd/planner/plan_route.h>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <random>
#include <thread>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// 120 m x 60 m of waves with a hill in the middle.
std::shared_ptr<const Terrain> Hill() {
  static const auto terrain =
      std::make_shared<const Terrain>(SurfaceTerrain(121, 61, 1, [](double x, double y) {
        return 0.2 * std::sin(0.3 * x) +
               8 * std::exp(-(std::pow(x - 60, 2) + std::pow(y - 30, 2)) / 300);
      }));
  return terrain;
}

PlanRequest AcrossTheHill() {
  PlanRequest request;
  request.start = {15, 30};
  request.goal = {105, 30};
  return request;
}

PlanOptions FewCandidates() {
  PlanOptions options;
  options.sampling.candidates = 8;
  options.sampling.roadmap_nodes = 300;
  options.sampling.planner_iterations = 200;
  return options;
}

Plan PlanHill(const PlanOptions& options, std::stop_token stop = {},
              const ProgressCallback& progress = {}) {
  return PlanRoute(Hill(), TestVehicle(), AcrossTheHill(), options, progress, stop);
}

/// What every answer must hold, however early it was cut short.
void ExpectConsistent(const Plan& plan) {
  EXPECT_EQ(plan.rollouts.size(), plan.candidates.size());
  EXPECT_EQ(plan.scores.size(), plan.candidates.size());
  EXPECT_FALSE(plan.reason.empty());
  const bool any_reached =
      std::any_of(plan.rollouts.begin(), plan.rollouts.end(),
                  [](const Rollout& rollout) { return rollout.outcome == Outcome::kReached; });
  EXPECT_EQ(plan.chosen.has_value(), any_reached);
  EXPECT_EQ(plan.first_route_time.has_value(), any_reached);
}

TEST(PlanRoute, FindsARouteAndTellsWhenTheFirstOneWasDriven) {
  const auto begin = Clock::now();
  const Plan plan = PlanHill(FewCandidates());
  EXPECT_EQ(plan.status, PlanStatus::kRoute);
  ExpectConsistent(plan);
  ASSERT_TRUE(plan.first_route_time.has_value());
  EXPECT_GT(*plan.first_route_time, 0);
  EXPECT_LT(*plan.first_route_time, SecondsSince(begin));
}

TEST(PlanRoute, AnswersWithTheBestSoFarWhenCancelledAfterTheFirstDrives) {
  std::stop_source source;
  PlanOptions options = FewCandidates();
  options.engine = RolloutEngine::kReference;  // one after the other
  options.threads = 1;
  const Plan plan =
      PlanHill(options, source.get_token(), [&](const std::string& stage, int done, int) {
        if (stage == "drive" && done == 3) source.request_stop();
      });
  ExpectConsistent(plan);
  EXPECT_EQ(plan.status, PlanStatus::kCancelled);
  ASSERT_TRUE(plan.chosen.has_value());
  EXPECT_TRUE(plan.reason.starts_with("cancelled: best so far, candidate "));
  EXPECT_EQ(plan.rollouts.back().outcome, Outcome::kCancelled);
}

TEST(PlanRoute, CancelledBeforeItBeganHasNoRoute) {
  std::stop_source source;
  source.request_stop();
  const Plan plan = PlanHill(FewCandidates(), source.get_token());
  EXPECT_EQ(plan.status, PlanStatus::kCancelled);
  EXPECT_EQ(plan.reason, "cancelled before a candidate reached the goal");
  ExpectConsistent(plan);
}

// Deadlines and cancels at moments all over a plan. How far they are overshot depends on what else
// the machine does: `deadline_benchmark` measures that, here is only what would be a defect.
TEST(PlanRoute, StopsAtAnyMoment) {
  PlanOptions options = FewCandidates();
  options.engine = RolloutEngine::kReference;
  const auto begin = Clock::now();
  PlanHill(options);
  const double whole = SecondsSince(begin);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 0.9);
  for (int i = 0; i < 6; ++i) {
    const double moment = share(random) * whole;
    const bool cancel = i % 2 == 0;
    options.deadline = cancel ? 1e6 : moment;
    std::stop_source source;
    const auto start = Clock::now();
    std::jthread canceller;
    if (cancel) {
      canceller = std::jthread([&source, moment] {
        std::this_thread::sleep_for(std::chrono::duration<double>(moment));
        source.request_stop();
      });
    }
    const Plan plan = PlanHill(options, source.get_token());
    EXPECT_LT(SecondsSince(start), moment + 1) << moment;
    ExpectConsistent(plan);
    if (plan.status == PlanStatus::kRoute) continue;  // done earlier than the first time
    EXPECT_EQ(plan.status, cancel ? PlanStatus::kCancelled : PlanStatus::kDeadline);
  }
}

PlanOptions InRounds() {
  PlanOptions options = FewCandidates();
  options.sampling.candidates = 16;  // 8, then twice 2 new ones and 2 variants
  return options;
}

TEST(PlanRoute, SpendsItsBudgetInRoundsThatNeverLose) {
  const Plan plan = PlanHill(InRounds());
  ExpectConsistent(plan);
  EXPECT_EQ(plan.candidates.size(), 16u);
  ASSERT_EQ(plan.rounds.size(), 3u);
  EXPECT_EQ(plan.rounds.front().name, "sample");
  EXPECT_EQ(plan.rounds.front().candidates, 8);
  EXPECT_EQ(plan.rounds[1].name, "learn");
  EXPECT_EQ(plan.rounds[1].candidates, 4);
  int driven = 0;
  double best = std::numeric_limits<double>::infinity();
  for (const PlanRound& round : plan.rounds) {
    driven += round.candidates;
    EXPECT_LE(round.best_score, best);
    best = round.best_score;
  }
  EXPECT_EQ(driven, 16);
  EXPECT_EQ(plan.scores[static_cast<std::size_t>(plan.chosen.value())].total, best);
}

TEST(PlanRoute, OneRoundLearnsNothing) {
  PlanOptions options = InRounds();
  options.learning.rounds = 1;
  const Plan plan = PlanHill(options);
  ASSERT_EQ(plan.rounds.size(), 1u);
  EXPECT_EQ(plan.rounds[0].candidates, 16);
}

TEST(PlanRoute, HasTheSameDigestForAnyNumberOfThreads) {
  PlanOptions options = InRounds();
  options.threads = 1;
  const std::uint64_t one = PlanHill(options).digest;
  for (const int threads : {2, 3}) {
    options.threads = threads;
    EXPECT_EQ(PlanHill(options).digest, one) << threads;
  }
  options.seed = 2;
  EXPECT_NE(PlanHill(options).digest, one);
}

TEST(PlanRoute, RefusesADeadlineInThePast) {
  PlanOptions options;
  options.deadline = -1;
  EXPECT_THROW(options.Validate(), InputError);
}

TEST(PlanRoute, WorksInTheCallersArenaWhenAsked) {
  PlanOptions options = FewCandidates();
  options.threads = kCallersArena;
  const auto self = std::this_thread::get_id();
  bool elsewhere = false;
  const auto look = [&](const std::string&, int, int) {
    elsewhere = elsewhere || std::this_thread::get_id() != self;
  };
  tbb::task_arena alone(1);
  Plan plan;
  alone.execute([&] { plan = PlanHill(options, {}, look); });
  EXPECT_FALSE(elsewhere);
  EXPECT_EQ(plan.digest, PlanHill(FewCandidates()).digest);
}

/// A lane of 6 m between posts, closed in the west: the vehicle stands in it, nose to the west.
std::shared_ptr<const Terrain> Lane() {
  std::vector<std::string> drawing(50, std::string(70, '.'));
  for (int column = 5; column < 32; ++column) drawing[21][column] = drawing[28][column] = '#';
  for (int row = 21; row <= 28; ++row) drawing[row][5] = '#';
  return std::make_shared<const Terrain>(DrawnTerrain(drawing, 1.0));
}

TEST(PlanRoute, BacksOutOfALaneWhereItMay) {
  PlanRequest request;
  request.start = {15, 24.5};
  request.start_heading = std::numbers::pi;
  request.goal = {60, 25};
  PlanOptions options = FewCandidates();
  const Plan forward = PlanRoute(Lane(), TestVehicle(), request, options);
  EXPECT_EQ(forward.status, PlanStatus::kNoGo);
  options.sampling.reversing = true;
  const Plan plan = PlanRoute(Lane(), TestVehicle(), request, options);
  ASSERT_EQ(plan.status, PlanStatus::kRoute) << plan.reason;
  ExpectConsistent(plan);
  const auto chosen = static_cast<std::size_t>(*plan.chosen);
  EXPECT_GT(plan.candidates[chosen].path.reverse_length(), 5);
  const std::vector<TraceSample>& trace = plan.rollouts[chosen].trace;
  EXPECT_TRUE(std::any_of(trace.begin(), trace.end(), [](const TraceSample& sample) {
    return sample.speed < -0.5 && sample.target_speed < -0.5;
  }));
  // The same for one thread and for the reference engine, which only rounds otherwise.
  options.threads = 1;
  EXPECT_EQ(PlanRoute(Lane(), TestVehicle(), request, options).digest, plan.digest);
  options.engine = RolloutEngine::kReference;
  const Plan reference = PlanRoute(Lane(), TestVehicle(), request, options);
  EXPECT_EQ(reference.chosen, plan.chosen);
}

TEST(PlanRoute, LanesChooseAsTheReferenceDoes) {
  PlanOptions options = FewCandidates();
  options.learning.rounds = 1;  // so that both drive the same routes
  const Plan lanes = PlanHill(options);
  options.engine = RolloutEngine::kReference;
  const Plan reference = PlanHill(options);
  EXPECT_EQ(lanes.chosen, reference.chosen);
  ASSERT_EQ(lanes.rollouts.size(), reference.rollouts.size());
  for (std::size_t i = 0; i < lanes.rollouts.size(); ++i) {
    EXPECT_EQ(lanes.rollouts[i].outcome, reference.rollouts[i].outcome) << i;
    EXPECT_NEAR(lanes.rollouts[i].time, reference.rollouts[i].time, 0.05) << i;
  }
}

}  // namespace
}  // namespace dbd
