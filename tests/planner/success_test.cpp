#include <dbd/planner/success.h>
#include <gtest/gtest.h>

#include <cmath>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

// z = 1.96: 8 of 10 gives (0.8 + 0.192) / 1.384 -+ 1.96 / 1.384 sqrt(0.016 + 0.0096), Newcombe
// 1998.
TEST(WilsonInterval, MatchesWhatIsPublished) {
  const Interval interval = WilsonInterval(8, 10);
  EXPECT_NEAR(interval.low, 0.490, 0.001);
  EXPECT_NEAR(interval.high, 0.943, 0.001);
}

// All of n: n / (n + z^2) = 32 / 35.84.
TEST(WilsonInterval, StaysBelowCertaintyAfterNothingButSuccess) {
  EXPECT_NEAR(WilsonInterval(32, 32).low, 0.8928, 1e-4);
  EXPECT_DOUBLE_EQ(WilsonInterval(32, 32).high, 1);
  EXPECT_NEAR(WilsonInterval(0, 32).high, 1 - 0.8928, 1e-4);
  EXPECT_EQ(WilsonInterval(0, 0).low, 0);
  EXPECT_EQ(WilsonInterval(0, 0).high, 1);
}

TEST(MeanOfLargest, TakesTheTail) {
  EXPECT_DOUBLE_EQ(MeanOfLargest({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.2), 9.5);
  EXPECT_DOUBLE_EQ(MeanOfLargest({3, 1}, 0.1), 3);
  EXPECT_EQ(MeanOfLargest({}, 0.1), 0);
}

// Jeffreys: after 16 of 16 the next succeeds with 33/34, after 0 of 16 with 1/34.
TEST(SuccessEstimate, PromisesNothingForCertain) {
  SuccessEstimate estimate;
  EXPECT_DOUBLE_EQ(estimate.p_go(), 0.5);
  estimate.draws = 16;
  EXPECT_DOUBLE_EQ(estimate.p_go(), 1.0 / 34);
  estimate.reached = 16;
  EXPECT_DOUBLE_EQ(estimate.p_go(), 33.0 / 34);
  EXPECT_DOUBLE_EQ(estimate.share(), 1);
}

TEST(SuccessEstimate, LiesInWilsonsInterval) {
  for (int draws = 1; draws <= 40; ++draws) {
    for (int reached = 0; reached <= draws; ++reached) {
      SuccessEstimate estimate;
      estimate.draws = draws, estimate.reached = reached;
      const Interval interval = WilsonInterval(reached, draws);
      EXPECT_GT(estimate.p_go(), interval.low);
      EXPECT_LT(estimate.p_go(), interval.high);
    }
  }
}

TEST(ExpectedCost, AFailureCostsAnotherTry) {
  SuccessEstimate estimate;
  estimate.draws = 10, estimate.reached = 5, estimate.mean_score = 40;
  EXPECT_DOUBLE_EQ(ExpectedCost(estimate), 80);
  estimate.reached = 10;
  EXPECT_DOUBLE_EQ(ExpectedCost(estimate), 40.0 * 11 / 10.5);
  estimate.reached = 0;
  EXPECT_TRUE(std::isinf(ExpectedCost(estimate)));
}

/// 100 m x 60 m: firm ground in the south, in the north soil whose strength is just enough on
/// average and varies much.
Terrain FirmAndDoubtful() {
  const HeightMap::Grid grid = TestGrid(101, 61, 1);
  Material firm = TestMaterial("firm", 1.5e6), doubtful = TestMaterial("doubtful", 1.6e5);
  firm.cone_index_spread = 0.05, doubtful.cone_index_spread = 0.5;
  doubtful.code = 1;
  std::vector<std::uint8_t> classes;
  for (int row = 0; row < 61; ++row) classes.insert(classes.end(), 101, row >= 30 ? 1 : 0);
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()),
                 HeightMap(grid, std::vector<float>(grid.CellCount(), 0.0f)),
                 MaterialMap(MaterialTable("two", {firm, doubtful}), grid, classes), ObstacleMap());
}

class Success : public testing::Test {
 protected:
  void SetUp() override {
    for (const double y : {45.0, 15.0}) {
      candidates_.push_back({"test", Path({{15, y}, {55, y}}), 10});
      Score score;
      score.feasible = true;
      score.total = y;
      scores_.push_back(score);
    }
    options_.uncertainty.draws = 16;
    options_.uncertainty.min_success = 0.9;
  }

  std::vector<std::optional<SuccessEstimate>> Estimate(int threads = 2) {
    options_.threads = threads;
    return EstimateSuccess(terrain_, *TestVehicle(), candidates_, scores_, options_, {}, {});
  }

  Terrain terrain_ = FirmAndDoubtful();
  std::vector<Candidate> candidates_;
  std::vector<Score> scores_;
  PlanOptions options_;
};

TEST_F(Success, TellsTheSafeRouteFromTheDoubtful) {
  const auto estimates = Estimate();
  ASSERT_TRUE(estimates[0] && estimates[1]);
  EXPECT_EQ(estimates[1]->reached, estimates[1]->draws);
  EXPECT_GT(estimates[0]->reached, 0);
  EXPECT_LT(estimates[0]->reached, estimates[0]->draws);
  EXPECT_FALSE(estimates[0]->failure.empty());
  EXPECT_GE(estimates[1]->cvar_time, estimates[1]->mean_time);
}

TEST_F(Success, IsTheSameForAnyNumberOfThreads) {
  const auto one = Estimate(1), three = Estimate(3);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i]->draws, three[i]->draws);
    EXPECT_EQ(one[i]->reached, three[i]->reached);
    EXPECT_EQ(one[i]->mean_time, three[i]->mean_time);
    EXPECT_EQ(one[i]->mean_score, three[i]->mean_score);
  }
}

TEST_F(Success, EndsEarlyWhenTheRankingIsSettled) {
  options_.uncertainty.draws = 1000;
  options_.uncertainty.min_success = 0.5;
  const auto estimates = Estimate();
  EXPECT_LT(estimates[1]->draws, 200);
  EXPECT_EQ(estimates[0]->draws, estimates[1]->draws);
}

TEST_F(Success, DrivesOnlyTheBestOfThoseThatArrived) {
  scores_[0] = {};
  options_.uncertainty.draws = 8;
  EXPECT_FALSE(Estimate()[0].has_value());
  scores_[0].feasible = true, scores_[0].total = 1;
  options_.uncertainty.survivors = 1;
  EXPECT_FALSE(Estimate()[1].has_value());
}

}  // namespace
}  // namespace dbd
