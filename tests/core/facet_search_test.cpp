#include "facet_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dbd {
namespace {

/// Two bins of 2 m side by side. In the western one the halves of a square, which slope 0.5 and
/// 0.25 eastwards; in the eastern one the second of them again, as seen from there.
class FacetSearch : public ::testing::Test {
 protected:
  FacetSearch() {
    // South-east of the diagonal (edges: south, east, diagonal), and north-west of it.
    const float d = std::sqrt(0.5F);
    const GroundFacet low = MakeFacet({{{0, 1, 0}, {-1, 0, 2}, {d, -d, 0}}}, {0.5F, 0, 1}, 7);
    const GroundFacet high = MakeFacet({{{0, -1, 2}, {1, 0, 0}, {-d, d, 0}}}, {0.25F, 0, 1}, 8);
    const GroundFacet again = MakeFacet({{{0, 1, 0}, {-1, 0, 0}, {d, -d, 2 * d}}}, {0.5F, 0, 2}, 7);
    facets = {low, high, again};
    ground = {2, 1, 100, 50, 2, 30, begin.data(), facets.data(), rim.data()};
  }

  static GroundFacet MakeFacet(const std::array<LinearFunction<float>, 3>& edges,
                               const LinearFunction<float>& height, std::uint32_t triangle) {
    GroundFacet facet;
    facet.edges = edges;
    facet.height = height;
    facet.triangle = triangle;
    return facet;
  }

  FacetsNear Find(double radius, double x, double y) const {
    FacetsNear near;
    FindFacetsNear(ground, radius, x, y, &near);
    return near;
  }

  std::vector<std::uint32_t> begin{0, 2, 3};
  std::vector<std::uint8_t> rim{0, 0};
  std::vector<GroundFacet> facets;
  GroundFacets ground;
};

TEST_F(FacetSearch, FindsWhatACircleTouches) {
  const FacetsNear alone = Find(0.2, 101.5, 50.5);
  ASSERT_EQ(alone.count, 1);
  EXPECT_NEAR(alone.facets[0].height.c, 1.75, 1e-6);              // seen from the place itself
  EXPECT_NEAR(alone.facets[0].edges[0].c, 0.5, 1e-6);             // to the south edge
  EXPECT_NEAR(alone.facets[0].edges[2].c, std::sqrt(0.5), 1e-6);  // to the diagonal
  EXPECT_EQ(Find(0.2, 101, 51).count, 2);
}

TEST_F(FacetSearch, CountsATriangleOfTwoBinsOnce) {
  const FacetsNear near = Find(0.3, 101.9, 50.4);  // reaches into the other bin
  ASSERT_EQ(near.count, 1);
  EXPECT_NEAR(near.facets[0].height.c, 1.95, 1e-6);
}

TEST_F(FacetSearch, KnowsWhereTheSurfaceEnds) {
  EXPECT_TRUE(Find(0.2, 101.5, 50.5).whole);
  rim[0] = 1;
  EXPECT_FALSE(Find(0.2, 101.5, 50.5).whole);
  EXPECT_FALSE(Find(0.2, 103, 51).whole);  // a bin's square without a triangle near
  EXPECT_EQ(Find(0.2, 500, std::nan("")).count, 0);
}

TEST_F(FacetSearch, BoundsAllHeightsByAPlane) {
  const FacetsNear near = Find(0.5, 101, 51);
  ASSERT_EQ(near.count, 2);
  for (double angle = 0; angle < 6.3; angle += 0.1) {
    const double x = 0.5 * std::cos(angle), y = 0.5 * std::sin(angle);
    const double bound = near.bound.a * x + near.bound.b * y + near.bound.c;
    EXPECT_GE(bound, 1.5 + 0.5 * x - 1e-9) << angle;
    EXPECT_GE(bound, 1.25 + 0.25 * x - 1e-9) << angle;
    EXPECT_LT(bound, 2.0) << angle;
  }
}

TEST_F(FacetSearch, GivesUpOnMoreThanFit) {
  facets.insert(facets.begin(), kMostFacetsNear, facets[0]);
  for (int i = 0; i < kMostFacetsNear; ++i)
    facets[i].triangle = static_cast<std::uint32_t>(100 + i);
  begin = {0, kMostFacetsNear + 2, kMostFacetsNear + 3};
  ground.facets = facets.data();
  ground.bin_begin = begin.data();
  const FacetsNear near = Find(0.2, 101.5, 50.5);
  EXPECT_EQ(near.count, 0);
  EXPECT_FALSE(near.whole);
}

}  // namespace
}  // namespace dbd
