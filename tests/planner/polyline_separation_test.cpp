#include <dbd/planner/polyline_separation.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dbd {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(Thin, KeepsTheEndsAndTheSpacing) {
  Points points;
  for (int i = 0; i <= 25; ++i) points.emplace_back(i, 0);
  const Points thin = Thin(points, 10);
  // 0, 10, 20 and the end.
  ASSERT_EQ(thin.size(), 4u);
  EXPECT_EQ(thin[2].x(), 20);
  EXPECT_EQ(thin[3].x(), 25);
}

TEST(DistanceToPolyline, IsToTheNearestPlaceOfASegment) {
  const Points line{{0, 0}, {10, 0}, {10, 10}};
  EXPECT_DOUBLE_EQ(DistanceToPolyline({5, 3}, line), 3);
  EXPECT_DOUBLE_EQ(DistanceToPolyline({13, 14}, line), 5);  // 3-4-5 from the end
  EXPECT_DOUBLE_EQ(DistanceToPolyline({10, 5}, line), 0);
}

TEST(Separation, OfParallelLinesIsTheirDistance) {
  const Points a{{0, 0}, {5, 0}, {10, 0}};
  const Points b{{0, 7}, {10, 7}};
  EXPECT_DOUBLE_EQ(Separation(a, b), 7);
  EXPECT_DOUBLE_EQ(Separation(b, a), 7);
  EXPECT_DOUBLE_EQ(Separation(a, a), 0);
}

TEST(SeparationUpTo, IsTheSeparationOrTheBound) {
  const Points a{{0, 0}, {5, 0}, {10, 0}};
  const Points b{{0, 7}, {4, 9}, {10, 7}};
  const double all = Separation(a, b);
  EXPECT_EQ(SeparationUpTo(all + 1, a, b), all);
  EXPECT_EQ(SeparationUpTo(all, a, b), all);
  EXPECT_EQ(SeparationUpTo(3, a, b), 3);
  // Near from one side only: the detour of the other is longer than the bound.
  const Points straight{{0, 0}, {100, 0}}, detour{{0, 0}, {50, 60}, {100, 0}};
  EXPECT_EQ(SeparationUpTo(15, straight, detour), 15);
  EXPECT_EQ(SeparationUpTo(15, detour, straight), 15);
  EXPECT_EQ(SeparationUpTo(25, straight, detour), 20);
}

TEST(NearestSeparations, AreToTheNearestOther) {
  const Points at0{{0, 0}, {10, 0}}, at3{{0, 3}, {10, 3}}, at10{{0, 10}, {10, 10}};
  EXPECT_EQ(NearestSeparations({at0, at3, at10}), (std::vector<double>{3, 3, 7}));
  EXPECT_TRUE(std::isinf(NearestSeparations({at0})[0]));
}

TEST(Separation, CountsADetourOfOneOfThem) {
  // a runs straight, b leaves it by 6 m at one of three points: means 0 and 2.
  const Points a{{0, 0}, {100, 0}};
  const Points b{{0, 0}, {50, 6}, {100, 0}};
  EXPECT_DOUBLE_EQ(Separation(a, b), 2);
}

}  // namespace
}  // namespace dbd
