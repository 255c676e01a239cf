#include <dbd/core/path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// 3 m east, then 4 m north.
Path Corner() { return Path(Points{{0, 0}, {3, 0}, {3, 4}}); }

Path Circle(double radius, int sides) {
  Points points;
  for (int i = 0; i <= sides; ++i) {
    const double a = 2 * std::numbers::pi * i / sides;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return Path(points);
}

TEST(Path, MeasuresLengthAlongItsSegments) {
  EXPECT_DOUBLE_EQ(Corner().length(), 7);
  EXPECT_EQ(Path().length(), 0);
  EXPECT_TRUE(Path().empty());
  EXPECT_FALSE(Corner().empty());
}

TEST(Path, PositionAndHeadingFollowTheSegments) {
  const Path path = Corner();
  EXPECT_NEAR((path.Position(2) - Eigen::Vector2d(2, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((path.Position(5) - Eigen::Vector2d(3, 2)).norm(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(path.Heading(1), 0);
  EXPECT_DOUBLE_EQ(path.Heading(6), std::numbers::pi / 2);
}

TEST(Path, UnevenSegmentsAreFoundFromBothEnds) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i)
    points.push_back({i < 20 ? 0.1 * i : 0.1 * i + (i - 19) * (i - 19), 0});
  const Path path(points);
  for (double s = -1; s < path.length() + 1; s += 0.05) {
    EXPECT_NEAR(path.Position(s).x(), s, 1e-9);
  }
  EXPECT_TRUE(std::isnan(path.Position(std::nan("")).x()));
}

TEST(Path, EndSegmentsGoOnStraight) {
  const Path path = Corner();
  EXPECT_NEAR((path.Position(-2) - Eigen::Vector2d(-2, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((path.Position(9) - Eigen::Vector2d(3, 6)).norm(), 0, 1e-15);
}

TEST(Path, DropsRepeatedPoints) {
  const Path path(Points{{0, 0}, {0, 0}, {1, 0}, {1, 0}, {2, 0}});
  EXPECT_EQ(path.points().size(), 3u);
  EXPECT_DOUBLE_EQ(path.length(), 2);
}

TEST(Path, CurvatureOfACircleIsOneOverItsRadius) {
  // 360 sides of 0.35 m at radius 20: a window of 3 m turns by 3/20 rad, within one side's 1 deg.
  const Path circle = Circle(20, 360);
  EXPECT_NEAR(circle.Curvature(30, 1.5), 0.05, 0.05 * 0.12);
  EXPECT_EQ(Corner().Curvature(1, 0.5), 0);
}

TEST(Path, CurvatureIsPositiveToTheLeftAndNegativeToTheRight) {
  EXPECT_GT(Corner().Curvature(3, 1), 0);
  EXPECT_LT(Path(Points{{0, 0}, {3, 0}, {3, -4}}).Curvature(3, 1), 0);
  // A quarter turn over the window of 2 m.
  EXPECT_NEAR(Corner().Curvature(3, 1), std::numbers::pi / 4, 1e-12);
}

TEST(Path, CurvatureIsContinuousWhereTheHeadingWraps) {
  // A full circle passes heading +-pi: no window may see a jump of 2 pi.
  const Path circle = Circle(20, 360);
  for (double s = 2; s < circle.length() - 2; s += 0.25) {
    EXPECT_LT(std::abs(circle.Curvature(s, 1.5) - 0.05), 0.01) << s;
  }
}

TEST(Path, NearestArcLengthProjectsOntoSegments) {
  const Path path = Corner();
  EXPECT_NEAR(path.NearestArcLength({1.5, 0.4}, 0, 7), 1.5, 1e-12);
  EXPECT_NEAR(path.NearestArcLength({3.3, 2.5}, 0, 7), 5.5, 1e-12);
  EXPECT_NEAR(path.NearestArcLength({-5, 1}, 0, 7), 0, 1e-12);
}

TEST(Path, NearestArcLengthSearchesOnlyItsWindow) {
  // There and back on the same line: the window decides which pass is meant.
  const Path path(Points{{0, 0}, {10, 0}, {10, 0.001}, {0, 0.001}});
  EXPECT_NEAR(path.NearestArcLength({4, 0}, 0, 9), 4, 1e-3);
  EXPECT_NEAR(path.NearestArcLength({4, 0}, 11, 20), 16, 2e-3);
  EXPECT_NEAR(path.NearestArcLength({4, 0}, 5, 9), 5, 1e-12);
}

TEST(Path, RefusesTooFewPointsAndBadNumbers) {
  EXPECT_EQ(InputErrorOf([] { Path(Points{}); }), "path: needs at least two distinct points");
  EXPECT_EQ(InputErrorOf([] {
              Path(Points{{1, 1}, {1, 1}});
            }),
            "path: needs at least two distinct points");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(InputErrorOf([&] {
              Path(Points{{0, 0}, {nan, 1}});
            }),
            "path: a point has a coordinate that is not a number");
}

/// 6 m east, then 4 m back in reverse, then 3 m north.
Path ForwardBackForward() {
  return Path(Points{{0, 0}, {6, 0}, {4, 0}, {2, 0}, {2, 3}}, {false, false, true, true, false});
}

TEST(Path, StretchesEndWhereTheDirectionChanges) {
  const Path path = ForwardBackForward();
  ASSERT_EQ(path.stretches().size(), 3u);
  EXPECT_EQ(path.stretches()[0].end, 6);
  EXPECT_EQ(path.stretches()[1].begin, 6);
  EXPECT_EQ(path.stretches()[1].end, 10);
  EXPECT_TRUE(path.stretches()[1].reverse);
  EXPECT_FALSE(path.stretches()[2].reverse);
  EXPECT_EQ(path.length(), 13);
  EXPECT_EQ(path.reverse_length(), 4);
  ASSERT_EQ(Corner().stretches().size(), 1u);
  EXPECT_EQ(Corner().reverse_length(), 0);
}

TEST(Path, TheVehiclePointsAgainstItsTravelInReverse) {
  const Path path = ForwardBackForward();
  EXPECT_EQ(path.VehicleHeading(3), 0);
  EXPECT_NEAR(std::abs(path.Heading(8)), std::numbers::pi, 1e-12);
  EXPECT_NEAR(path.VehicleHeading(8), 0, 1e-12);
  EXPECT_NEAR(path.VehicleHeading(12), std::numbers::pi / 2, 1e-12);
}

TEST(Path, AStretchGoesOnStraightBeyondItsEnd) {
  const Path path = ForwardBackForward();
  EXPECT_LT((path.PositionOn(path.stretches()[0], 8) - Eigen::Vector2d(8, 0)).norm(), 1e-12);
  EXPECT_LT((path.PositionOn(path.stretches()[1], 11) - Eigen::Vector2d(1, 0)).norm(), 1e-12);
  EXPECT_LT((path.PositionOn(path.stretches()[2], 15) - Eigen::Vector2d(2, 5)).norm(), 1e-12);
}

TEST(Path, NoCurvatureIsSeenAcrossAChangeOfDirection) {
  const Path path = ForwardBackForward();
  for (double s = 0; s < path.length(); s += 0.25) EXPECT_EQ(path.Curvature(s, 1.5), 0) << s;
}

}  // namespace
}  // namespace dbd
