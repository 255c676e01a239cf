#include "reeds_shepp.h"

#include <dbd/core/driver.h>
#include <dbd/planner/candidate_curve.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "candidate_test_terrain.h"
#include "ompl_pose.h"

namespace dbd {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 6;

ReedsSheppSpace Space() { return {kRadius, {-100, -100}, {100, 100}}; }

double LengthOf(Pose2 from, const std::vector<Pose2>& waypoints) {
  double length = 0;
  for (const Pose2& to : waypoints) {
    length += ShortestDubinsCurve(from, to, kRadius).length();
    from = to;
  }
  return length;
}

TEST(ReedsShepp, BacksStraight) {
  const std::vector<Pose2> way = Space().Waypoints({0, 0, 0}, {-5, 0, 0});
  ASSERT_EQ(way.size(), 1u);
  EXPECT_TRUE(way[0].reverse);
  EXPECT_NEAR(LengthOf({0, 0, 0}, way), 5, 1e-9);
}

TEST(ReedsShepp, TurnsRoundOnTheSpotInThreeStretches) {
  // Three arcs of 60 degrees, forward, back and forward: pi radii (Dubins: 7 pi / 3).
  const std::vector<Pose2> way = Space().Waypoints({0, 0, 0}, {0, 0, kPi});
  EXPECT_NEAR(LengthOf({0, 0, 0}, way), kPi * kRadius, 1e-6);
  ASSERT_EQ(way.size(), 3u);
  EXPECT_NE(way[0].reverse, way[1].reverse);
  EXPECT_NE(way[1].reverse, way[2].reverse);
}

TEST(ReedsShepp, PiecesMakeUpTheWholeCurve) {
  const ReedsSheppSpace space = Space();
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(-30, 30), angle(-kPi, kPi);
  ompl::base::State* one = space.allocState();
  ompl::base::State* other = space.allocState();
  for (int i = 0; i < 5000; ++i) {
    const Pose2 from{place(generator), place(generator), angle(generator)};
    const Pose2 to{place(generator), place(generator), angle(generator)};
    SetPose(from, one);
    SetPose(to, other);
    const std::vector<Pose2> way = space.Waypoints(from, to);
    const double length = LengthOf(from, way);
    EXPECT_NEAR(length, space.distance(one, other), 1e-4) << i;
    EXPECT_LE(length, ShortestDubinsCurve(from, to, kRadius).length() + 1e-6) << i;
    EXPECT_EQ(way.back().position(), to.position());
  }
  space.freeState(one);
  space.freeState(other);
}

TEST(ReedsShepp, CostsCountTheChangesAndTheSlowReverse) {
  const Terrain terrain = SurfaceTerrain(61, 61, 1, [](double, double) { return 0.0; });
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  const Pose2 from{30, 30, 0};
  const double ahead = WaypointsCost(layer, from, {{40, 30, 0}}, kRadius);
  const double back = WaypointsCost(layer, from, {{20, 30, 0, true}}, kRadius);
  EXPECT_NEAR(back, 10 * (1 / kReverseSpeed + kReverseCost) + kGearChangeCost, 1e-9);
  EXPECT_NEAR(WaypointsCost(layer, from, {{40, 30, 0}, {30, 30, 0, true}}, kRadius), ahead + back,
              1e-9);
  const std::vector<Pose2> dense = DensePoses({from, {40, 30, 0}, {30, 30, 0, true}}, kRadius);
  EXPECT_NEAR(PosesCost(layer, dense), ahead + back, 1e-6);
  EXPECT_TRUE(Reverses(dense));
  const Path path = PathAlong(dense, {30, 30}, {30, 30});
  EXPECT_EQ(path.stretches().size(), 2u);
  EXPECT_NEAR(path.reverse_length(), 10, 1e-9);
}

}  // namespace
}  // namespace dbd
