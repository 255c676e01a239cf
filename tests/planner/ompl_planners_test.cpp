#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/ompl_planners.h>
#include <gtest/gtest.h>

#include <numbers>
#include <thread>
#include <vector>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

class OmplPlanners : public testing::TestWithParam<OmplPlanner> {
 protected:
  OmplPlanners()
      : terrain_(SurfaceTerrain(
            201, 201, 1.0,
            [](double x, double y) { return 9 * std::sin(x / 17) * std::sin(y / 23); })),
        layer_(terrain_, *TestVehicle(), 8.0) {
    query_.turning_radius = 4;
    query_.starts = {{20, 20, 0}, {20, 20, 1.5}};
    query_.goals = {{180, 170, 0}, {180, 170, 1.5}};
    query_.min_corner = layer_.min_corner();
    query_.max_corner = layer_.max_corner();
  }

  std::vector<Pose2> Solve(std::uint64_t seed) const {
    return SolveWithOmpl(GetParam(), layer_, query_, seed, 1500);
  }

  Terrain terrain_;
  TrafficabilityLayer layer_;
  OmplQuery query_;
};

void ExpectSame(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].x, b[i].x);
    EXPECT_EQ(a[i].y, b[i].y);
    EXPECT_EQ(a[i].heading, b[i].heading);
  }
}

TEST_P(OmplPlanners, FindRoutesThatHoldBeforeTheLayer) {
  const std::vector<Pose2> route = Solve(1);
  ASSERT_GE(route.size(), 2u);
  EXPECT_EQ(route.front().position(), query_.starts[0].position());
  EXPECT_EQ(route.back().position(), query_.goals[0].position());
  EXPECT_TRUE(AllGo(layer_, DensePoses(route, 4)));
}

TEST_P(OmplPlanners, SameSeedSameRouteWhateverElseRuns) {
  const std::vector<Pose2> alone = Solve(3);
  std::vector<std::vector<Pose2>> together(4);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] { together[i] = Solve(i == 2 ? 3 : 100 + i); });
  }
  for (std::thread& thread : threads) thread.join();
  ExpectSame(together[2], alone);
}

TEST_P(OmplPlanners, OtherSeedOtherRoute) {
  const std::vector<Pose2> a = Solve(5);
  const std::vector<Pose2> b = Solve(6);
  ASSERT_FALSE(a.empty());
  ASSERT_FALSE(b.empty());
  EXPECT_FALSE(a.size() == b.size() && a[a.size() / 2].x == b[b.size() / 2].x);
}

TEST_P(OmplPlanners, PrintNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Solve(7);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(All, OmplPlanners,
                         testing::Values(OmplPlanner::kRrtConnect, OmplPlanner::kAbitStar));

TEST(OmplPlanners, ReedsSheppRoutesHoldBeforeTheLayer) {
  // Turning round on a strip that is too narrow for a turn in one go.
  std::vector<std::string> drawing(16, std::string(60, '.'));
  for (char& mark : drawing[0]) mark = '#';
  for (char& mark : drawing[15]) mark = '#';
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  OmplQuery query;
  query.turning_radius = TestVehicle()->min_turning_radius();
  query.starts = {{30, 7.5, 0}};
  query.goals = {{10, 7.5, WrapAngle(std::numbers::pi)}};
  query.min_corner = layer.min_corner();
  query.max_corner = layer.max_corner();
  query.reversing = true;
  ASSERT_TRUE(layer.Evaluate(30, 7.5, 0).go());
  ASSERT_TRUE(layer.Evaluate(10, 7.5, std::numbers::pi).go());
  const std::vector<Pose2> way = SolveWithOmpl(OmplPlanner::kRrtConnect, layer, query, 5, 20000);
  ASSERT_FALSE(way.empty());
  const std::vector<Pose2> dense = DensePoses(way, query.turning_radius);
  EXPECT_TRUE(AllGo(layer, dense));
  EXPECT_TRUE(Reverses(dense));
  EXPECT_EQ(way.back().position(), query.goals[0].position());
}

TEST(OmplPlanners, EndsThatFaceDueWestAreEndsToo) {
  // OMPL's headings lie in [-pi, pi), ours in (-pi, pi].
  const Terrain terrain = SurfaceTerrain(61, 61, 1, [](double, double) { return 0.0; });
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  OmplQuery query;
  query.turning_radius = TestVehicle()->min_turning_radius();
  query.starts = {{50, 30, std::numbers::pi}};
  query.goals = {{10, 32, std::numbers::pi}};
  query.min_corner = layer.min_corner();
  query.max_corner = layer.max_corner();
  EXPECT_FALSE(SolveWithOmpl(OmplPlanner::kRrtConnect, layer, query, 5, 2000).empty());
}

}  // namespace
}  // namespace dbd
