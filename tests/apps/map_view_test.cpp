#include "map_view.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

HeightMap Flat(int columns, int rows) {
  return HeightMap({columns, rows, {0, 0}, {1, 1}},
                   std::vector<float>(static_cast<std::size_t>(columns) * rows, 5.0f));
}

TEST(FitView, ShowsTheWholeMapWithoutPoints) {
  const MapView view = FitView(Flat(201, 101), {}, 1000);
  EXPECT_EQ(view.north_west, Eigen::Vector2d(0, 100));
  EXPECT_DOUBLE_EQ(view.pixel_size, 0.2);  // 200 m on 1000 pixels
  EXPECT_EQ(view.height, 500);
}

TEST(FitView, CropsToThePointsWithAMargin) {
  // A box of 200 m x 150 m, 24 m margin (12 % of 200 m) on each side: 248 m x 198 m.
  const MapView view = FitView(Flat(1001, 1001), {{400, 400}, {600, 550}}, 1000);
  EXPECT_NEAR(view.pixel_size, 0.248, 1e-12);
  EXPECT_NEAR(view.north_west.x(), 376, 1e-9);
  EXPECT_NEAR(view.north_west.y(), 574, 1e-9);
}

TEST(FitView, StaysInsideTheMapAndWithinTheAspect) {
  // 24 m margin: 48 m x 248 m at the east edge, cut to x <= 1000, then widened to a square.
  const MapView view = FitView(Flat(1001, 1001), {{1000, 400}, {1000, 600}}, 1000);
  EXPECT_EQ(view.height, 1000);
  EXPECT_NEAR(view.north_west.x() + view.width * view.pixel_size, 1000, 1e-9);
}

TEST(MapView, PixelsAndPlacesAreInverse) {
  const MapView view{{10, 90}, 0.5, 100, 80};
  EXPECT_EQ(view.ToPixel({15, 80}), Eigen::Vector2d(10, 20));
  EXPECT_EQ(view.ToLocal({10, 20}), Eigen::Vector2d(15, 80));
}

}  // namespace
}  // namespace dbd
