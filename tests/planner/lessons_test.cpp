#include <dbd/planner/lessons.h>
#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

/// A drive to the east along y from x = 10 to 90, at 5 m/s but at `slow` from x = 40 to 60.
Rollout DriveEast(double y, double slow) {
  Rollout rollout;
  rollout.outcome = Outcome::kReached;
  for (double x = 10; x <= 90; x += 1) {
    TraceSample sample;
    sample.x = x;
    sample.y = y;
    sample.s = x - 10;
    sample.t = rollout.time;
    rollout.time += 1 / (x >= 40 && x < 60 ? slow : 5.0);
    rollout.trace.push_back(sample);
  }
  return rollout;
}

class Lessons : public testing::Test {
 protected:
  ExtraCost Learn(const std::vector<Rollout>& rollouts) const {
    return LearnFromRollouts(layer_, rollouts, {});
  }

  Terrain terrain_ = SurfaceTerrain(101, 61, 1, [](double, double) { return 0.0; });
  TrafficabilityLayer layer_{terrain_, *TestVehicle(), 8.0};
};

TEST_F(Lessons, NothingIsLearntFromNothingOrFromWhatWasExpectedEverywhere) {
  EXPECT_EQ(Learn({}).SecondsPerMetre(50, 30), 0);
  const ExtraCost even = Learn({DriveEast(30, 5)});
  for (double x = 12; x < 88; x += 4) EXPECT_NEAR(even.SecondsPerMetre(x, 30), 0, 1e-6);
}

TEST_F(Lessons, SlowPlacesCostMoreThanFastOnes) {
  const ExtraCost cost = Learn({DriveEast(30, 1)});
  EXPECT_GT(cost.SecondsPerMetre(50, 30), 0.05);
  EXPECT_EQ(cost.SecondsPerMetre(20, 30), 0);
  EXPECT_EQ(cost.SecondsPerMetre(50, 50), 0);  // nobody was there
}

// Each failure adds 60 s for whoever drives through its middle: 60 / 12 m at the tip.
TEST_F(Lessons, FailuresAddUp) {
  Rollout failed;
  failed.outcome = Outcome::kImmobilized;
  failed.place = {50, 30, 0};
  const double once = Learn({failed}).SecondsPerMetre(50, 30);
  EXPECT_NEAR(once, 5, 1.2);  // the grid of 4 m rounds the tip off
  EXPECT_NEAR(Learn({failed, failed}).SecondsPerMetre(50, 30), 2 * once, 1e-6);
  failed.outcome = Outcome::kTimedOut;
  EXPECT_EQ(Learn({failed}).SecondsPerMetre(50, 30), 0);
}

TEST_F(Lessons, ATightLimitCostsWhatTheScoreChargesForIt) {
  Rollout tight;
  tight.outcome = Outcome::kReached;
  tight.margins = {{"roll", 0.5, 0.5, 0.0, 40, {50, 30}}};  // nothing left: 30 s
  const double cost = Learn({tight}).SecondsPerMetre(50, 30);
  EXPECT_NEAR(cost, 30.0 / 12, 0.6);
  EXPECT_NEAR(Learn({tight, tight}).SecondsPerMetre(50, 30), cost, 1e-6);
}

TEST_F(Lessons, TheLayerAddsThemToItsOwnCost) {
  Rollout failed;
  failed.outcome = Outcome::kCollided;
  failed.place = {50, 30, 0};
  const auto extra = std::make_shared<const ExtraCost>(Learn({failed}));
  const TrafficabilityLayer learned = layer_.WithExtraCost(extra);
  const double before = layer_.SecondsPerMetre(50, 30, 0);
  EXPECT_GT(learned.SecondsPerMetre(50, 30, 0), before + 2);
  EXPECT_EQ(learned.SecondsPerMetre(80, 30, 0), layer_.SecondsPerMetre(80, 30, 0));
  EXPECT_EQ(layer_.SecondsPerMetre(50, 30, 0), before);
}

}  // namespace
}  // namespace dbd
