#include <dbd/planner/dubins.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace dbd {
namespace {

constexpr double kPi = std::numbers::pi;

double Miss(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + std::abs(WrapAngle(a.heading - b.heading));
}

class RandomPoses {
 public:
  explicit RandomPoses(double extent) : place_(-extent, extent) {}
  Pose2 Next() { return {place_(generator_), place_(generator_), angle_(generator_)}; }

 private:
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> place_;
  std::uniform_real_distribution<double> angle_{-kPi, kPi};
};

TEST(WrapAngle, KeepsTheDirection) {
  EXPECT_NEAR(WrapAngle(3 * kPi), kPi, 1e-12);
  EXPECT_NEAR(WrapAngle(-kPi), kPi, 1e-12);
  EXPECT_NEAR(WrapAngle(2 * kPi + 0.25), 0.25, 1e-12);
}

TEST(Dubins, KnownLengths) {
  const Pose2 origin{0, 0, 0};
  // Straight ahead.
  EXPECT_NEAR(ShortestDubinsCurve(origin, {10, 0, 0}, 3).length(), 10.0, 1e-9);
  // Half a circle to the left: pi * 3.
  EXPECT_NEAR(ShortestDubinsCurve(origin, {0, 6, kPi}, 3).length(), 3 * kPi, 1e-9);
  // Two left turns of pi/2 in all, about centres (0, 3) and (4, 7): 4 sqrt(2) + 3 pi / 2.
  EXPECT_NEAR(ShortestDubinsCurve(origin, {7, 7, kPi / 2}, 3).length(),
              4 * std::sqrt(2.0) + 1.5 * kPi, 1e-9);
  EXPECT_NEAR(ShortestDubinsCurve(origin, origin, 3).length(), 0.0, 1e-9);
}

TEST(Dubins, ThreeTurnsWhenPosesAreClose) {
  // Turning round on the spot, radius 1: RLR with outer turns of pi/3 and a middle of 5 pi/3
  // (three unit circles touching, their centres an equilateral triangle of side 2): 7 pi / 3.
  const DubinsCurve curve = ShortestDubinsCurve({0, 0, 0}, {0, 0, kPi}, 1);
  EXPECT_NEAR(curve.length(), 7 * kPi / 3, 1e-9);
  EXPECT_NE(curve.turns[1], Turn::kStraight);
}

TEST(Dubins, ReachesRandomEndsAndIsNoShorterThanTheStraightLine) {
  for (const double extent : {5.0, 50.0, 1000.0}) {
    RandomPoses poses(extent);
    for (int i = 0; i < 20000; ++i) {
      const Pose2 from = poses.Next();
      const Pose2 to = poses.Next();
      const DubinsCurve curve = ShortestDubinsCurve(from, to, 6);
      ASSERT_GE(curve.length(), std::hypot(to.x - from.x, to.y - from.y) - 1e-9);
      ASSERT_LT(Miss(DubinsSampler(from, curve).At(curve.length()), to), 1e-6);
    }
  }
}

TEST(Dubins, IsAsLongDrivenBackwards) {
  RandomPoses poses(20);
  for (int i = 0; i < 20000; ++i) {
    const Pose2 a = poses.Next();
    const Pose2 b = poses.Next();
    const Pose2 a_turned{a.x, a.y, a.heading + kPi};
    const Pose2 b_turned{b.x, b.y, b.heading + kPi};
    ASSERT_NEAR(ShortestDubinsCurve(a, b, 4).length(),
                ShortestDubinsCurve(b_turned, a_turned, 4).length(), 1e-6);
  }
}

TEST(Dubins, SamplesMoveAtUnitSpeedAndTurnNoTighterThanTheRadius) {
  RandomPoses poses(30);
  for (int i = 0; i < 200; ++i) {
    const Pose2 from = poses.Next();
    const DubinsCurve curve = ShortestDubinsCurve(from, poses.Next(), 5);
    const DubinsSampler sampler(from, curve);
    for (double s = 0; s + 0.1 < curve.length(); s += 0.1) {
      const Pose2 a = sampler.At(s);
      const Pose2 b = sampler.At(s + 0.1);
      ASSERT_LE(std::hypot(b.x - a.x, b.y - a.y), 0.1 + 1e-9);
      ASSERT_LE(std::abs(WrapAngle(b.heading - a.heading)), 0.1 / 5 + 1e-9);
    }
  }
}

// Two states of one curve are joined by that curve: rounding must not add a full circle.
void ExpectNoCircles(double noise) {
  RandomPoses poses(1000);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> error(-noise, noise);
  int circles = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose2 from = poses.Next();
    const DubinsSampler sampler(from, ShortestDubinsCurve(from, poses.Next(), 6));
    for (double s = 0; s + 1.0 < sampler.length(); s += 1.0) {
      Pose2 a = sampler.At(s);
      Pose2 b = sampler.At(s + 1.0);
      b.x += error(generator), b.y += error(generator), b.heading += error(generator);
      if (ShortestDubinsCurve(a, b, 6).length() > 1.1) ++circles;
    }
  }
  EXPECT_EQ(circles, 0);
}

TEST(Dubins, NeighboursOnOneCurveGetNoFullCircle) { ExpectNoCircles(0); }
TEST(Dubins, NeighboursWithRoundingNoiseGetNoFullCircle) { ExpectNoCircles(1e-9); }

TEST(Dubins, DirectionsAreThoseOfTheHeadings) {
  RandomPoses poses(30);
  for (int i = 0; i < 200; ++i) {
    const Pose2 from = poses.Next();
    Pose2 to = poses.Next();
    to.reverse = i % 2 == 1;
    const DubinsCurve curve = ShortestDubinsCurve(from, to, 5);
    const DubinsSampler sampler(from, curve);
    for (double s = 0; s < curve.length(); s += 0.7) {
      const DirectedPose pose = sampler.At(s);
      ASSERT_EQ(pose.cos_h, std::cos(pose.heading));
      ASSERT_EQ(pose.sin_h, std::sin(pose.heading));
    }
    EXPECT_EQ(ShortestDubinsCurve(DirectedPose(from), DirectedPose(to), 5).lengths, curve.lengths);
  }
}

TEST(Dubins, InReverseItIsTheCurveOfTheVehicleTurnedRound) {
  const DubinsCurve straight = ShortestDubinsCurve({0, 0, 0}, {-10, 0, 0, true}, 3);
  EXPECT_TRUE(straight.reverse);
  EXPECT_NEAR(straight.length(), 10, 1e-9);
  RandomPoses poses(30);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 from = poses.Next();
    Pose2 to = poses.Next();
    to.reverse = true;
    const DubinsCurve curve = ShortestDubinsCurve(from, to, 6);
    const DubinsSampler sampler(from, curve);
    EXPECT_LT(Miss(sampler.At(curve.length()), to), 1e-5);
    EXPECT_LT(Miss(sampler.At(0), from), 1e-9);
    // It moves against where the vehicle points.
    const Pose2 a = sampler.At(0.5 * curve.length()), b = sampler.At(0.5 * curve.length() + 1e-3);
    const Eigen::Vector2d ahead(std::cos(a.heading), std::sin(a.heading));
    EXPECT_LT((b.position() - a.position()).dot(ahead), 0);
    EXPECT_TRUE(a.reverse);
    // Time runs backwards: the forward curve from `to` to `from` is as long.
    EXPECT_NEAR(curve.length(), ShortestDubinsCurve(to, {from.x, from.y, from.heading}, 6).length(),
                1e-6);
  }
}

}  // namespace
}  // namespace dbd
