#include <dbd/core/error.h>
#include <dbd/planner/planning_service.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <random>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

/// 60 m x 40 m of gentle waves; `seed` chooses start and goal.
PlanInputs SmallInputs(int seed) {
  static const auto terrain = std::make_shared<const Terrain>(SurfaceTerrain(
      61, 41, 1, [](double x, double y) { return 0.2 * std::sin(0.3 * x) * std::cos(0.2 * y); }));
  PlanInputs inputs{terrain, TestVehicle(), {}, {}};
  inputs.request.start = {8, 12.0 + seed % 5};
  inputs.request.goal = {40.0 + seed % 7, 25};
  inputs.options.sampling.candidates = 3;
  inputs.options.sampling.roadmap_nodes = 300;
  inputs.options.sampling.planner_iterations = 200;
  inputs.options.seed = static_cast<std::uint64_t>(seed);
  return inputs;
}

PlanInputs Refuse() { throw InputError("request: start: is not on the map"); }

TEST(PlanningService, AnswersAsPlanRouteDoesWhateverRunsBeside) {
  PlanningService service({.threads = 3});
  std::vector<PlanningService::Handle> handles;
  for (int i = 0; i < 6; ++i) {
    handles.push_back(service.Submit({.prepare = [i] { return SmallInputs(i); }}));
    handles.push_back(service.Submit({.prepare = Refuse}));
  }
  for (int i = 0; i < 6; ++i) {
    const PlanInputs alone = SmallInputs(i);
    const Plan plan = PlanRoute(alone.terrain, alone.vehicle, alone.request, alone.options);
    const JobResult& result = handles[static_cast<std::size_t>(2 * i)].Wait();
    EXPECT_EQ(result.state, JobState::kDone);
    EXPECT_EQ(result.plan.digest, plan.digest) << i;
    EXPECT_EQ(result.plan.status, PlanStatus::kRoute);
    const JobResult& bad = handles[static_cast<std::size_t>(2 * i + 1)].Wait();
    EXPECT_EQ(bad.state, JobState::kFailed);
    EXPECT_EQ(bad.error, "request: start: is not on the map");
  }
}

TEST(PlanningService, JobsOfOneTerrainAndVehicleShareTheirLayer) {
  PlanningService service({.threads = 2});
  const PlanInputs inputs = SmallInputs(1);
  for (int i = 0; i < 4; ++i) service.Submit({.prepare = [&] { return inputs; }});
  service.Drain();
  EXPECT_EQ(service.layers().makes(), 1U);
}

/// A service of one worker that is kept busy until the gate opens.
class GatedService : public testing::Test {
 protected:
  GatedService() {
    std::promise<void> begun;
    service_.Submit({.prepare = [this, &begun]() -> PlanInputs {
      begun.set_value();
      gate_.get_future().wait();
      return Refuse();
    }});
    begun.get_future().wait();
  }

  PlanJob Named(char name, int priority) {
    return {.prepare = Refuse, .priority = priority, .on_end = [this, name](const JobResult&) {
              order_ += name;
            }};
  }

  std::promise<void> gate_;
  std::string order_;
  PlanningService service_{{.threads = 1, .queue_limit = 4}};
};

TEST_F(GatedService, HigherPrioritiesFirstThenFirstCome) {
  service_.Submit(Named('c', 0));
  service_.Submit(Named('a', 2));
  service_.Submit(Named('d', 0));
  service_.Submit(Named('b', 1));
  gate_.set_value();
  service_.Drain();
  EXPECT_EQ(order_, "abcd");
}

TEST_F(GatedService, AFullQueueHoldsSubmittersBack) {
  for (const char name : {'a', 'b', 'c'}) service_.Submit(Named(name, 0));
  auto last = service_.TrySubmit(Named('d', 0));
  ASSERT_TRUE(last);
  EXPECT_FALSE(service_.TrySubmit(Named('x', 0)));
  auto waiting = std::async(std::launch::async, [&] { service_.Submit(Named('e', 0)); });
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(30)), std::future_status::timeout);
  EXPECT_FALSE(last->WaitFor(std::chrono::milliseconds(5)));
  last->Cancel();  // makes room at once
  EXPECT_TRUE(last->WaitFor(std::chrono::milliseconds(0)));
  EXPECT_EQ(waiting.wait_for(std::chrono::seconds(10)), std::future_status::ready);
  EXPECT_EQ(last->Wait().state, JobState::kCancelled);
  gate_.set_value();
  service_.Drain();
  EXPECT_EQ(order_, "dabce");
}

TEST(PlanningService, CancelsWhatRuns) {
  PlanningService service({.threads = 1});
  std::promise<PlanningService::Handle> self;
  auto handle = service.Submit({.prepare = [&] {
    self.get_future().get().Cancel();
    return SmallInputs(1);
  }});
  self.set_value(handle);
  EXPECT_EQ(handle.Wait().state, JobState::kCancelled);
}

TEST(PlanningService, EndsCleanlyWithWorkInFlight) {
  std::atomic<int> ended = 0, cancelled = 0;
  {
    PlanningService service({.threads = 2});
    for (int i = 0; i < 20; ++i) {
      service.Submit({.prepare = [i] { return SmallInputs(i); },
                      .on_end =
                          [&](const JobResult& result) {
                            ++ended;
                            cancelled += result.state == JobState::kCancelled;
                          }});
    }
  }
  EXPECT_EQ(ended, 20);
  EXPECT_GT(cancelled, 10);
}

TEST(PlanningService, ManyClientsSubmitAndCancelAtRandom) {
  std::atomic<int> ended = 0;
  constexpr int kClients = 8, kJobs = 25;
  PlanningService service({.threads = 2, .queue_limit = 5});
  std::vector<std::jthread> clients;
  for (int c = 0; c < kClients; ++c) {
    clients.emplace_back([&service, &ended, c] {
      std::minstd_rand random(static_cast<unsigned>(c + 1));
      for (int i = 0; i < kJobs; ++i) {
        const bool plans = random() % 10 == 0;
        auto handle =
            service.Submit({.prepare = [plans] { return plans ? SmallInputs(2) : Refuse(); },
                            .priority = static_cast<int>(random() % 3),
                            .on_end = [&](const JobResult&) { ++ended; }});
        if (random() % 2 == 0) handle.Cancel();
        if (random() % 4 == 0) handle.Wait();
      }
    });
  }
  clients.clear();
  service.Drain();
  EXPECT_EQ(ended, kClients * kJobs);
}

TEST(PlanningService, HandlesOutliveIt) {
  auto service = std::make_unique<PlanningService>(PlanningService::Options{.threads = 1});
  auto handle = service->Submit({.prepare = Refuse});
  handle.Wait();
  service.reset();
  handle.Cancel();
  EXPECT_EQ(handle.state(), JobState::kFailed);
  EXPECT_STREQ(JobStateName(handle.state()), "failed");
}

}  // namespace
}  // namespace dbd
