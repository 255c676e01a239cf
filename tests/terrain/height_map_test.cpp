#include <dbd/core/error.h>
#include <dbd/terrain/height_map.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

HeightMap::Grid MakeGrid(int columns, int rows, double cell_x = 1, double cell_y = 1) {
  return {columns, rows, {10, -5}, {cell_x, cell_y}};
}

HeightMap MakePlane(double base) {
  const HeightMap::Grid grid = MakeGrid(6, 5, 0.5, 2.0);
  std::vector<float> heights;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d center = grid.Center(column, row);
      heights.push_back(static_cast<float>(0.25 * center.x() - 0.5 * center.y()));
    }
  }
  return HeightMap(grid, heights, base);
}

TEST(HeightMap, IsExactOnAPlane) {
  const HeightMap map = MakePlane(1000);
  // z = 1000 + 0.25 * 11.3 - 0.5 * (-1.1) = 1000 + 2.825 + 0.55.
  EXPECT_NEAR(map.Height(11.3, -1.1), 1003.375, 1e-9);
  EXPECT_NEAR(map.Height(10, -5), 1000 + 2.5 + 2.5, 1e-9);
  EXPECT_NEAR(map.Height(12.5, 3), 1000 + 3.125 - 1.5, 1e-9);
}

TEST(HeightMap, BlendsFourCorners) {
  const HeightMap map(MakeGrid(2, 2), {1, 2, 3, 8});
  // South edge at 1/4: 1.25; north edge: 3 + 0.25 * 5 = 4.25; half way: 2.75.
  EXPECT_DOUBLE_EQ(map.Height(10.25, -4.5), 2.75);
}

TEST(HeightMap, ContinuesItsEdgeOutside) {
  const HeightMap map(MakeGrid(2, 2), {1, 2, 3, 8});
  EXPECT_DOUBLE_EQ(map.Height(-100, -100), 1);
  EXPECT_DOUBLE_EQ(map.Height(1e9, 1e9), 8);
  EXPECT_DOUBLE_EQ(map.Height(10.5, 1e300), 5.5);
  EXPECT_TRUE(std::isfinite(map.Height(std::nan(""), 0)));
}

TEST(HeightMap, AnswersForManyPlacesAsForOne) {
  const HeightMap map = MakePlane(0);
  const double x[] = {10.1, 11.7, 12.4};
  const double y[] = {-4.0, 0.3, 2.9};
  double z[3];
  map.Heights(3, x, y, z);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(z[i], map.Height(x[i], y[i]));
}

TEST(HeightMap, FillsUnknownCellsFromTheNearestAndMarksThem) {
  const HeightMap map(MakeGrid(4, 3), {kNan, kNan, kNan, 9,  //
                                       kNan, kNan, kNan, 9,  //
                                       4, 4, kNan, 9});
  EXPECT_DOUBLE_EQ(map.CellHeight(0, 0), 4);
  EXPECT_DOUBLE_EQ(map.CellHeight(2, 0), 9);
  EXPECT_DOUBLE_EQ(map.unknown_share(), 7.0 / 12.0);
  EXPECT_DOUBLE_EQ(map.lowest(), 4);
  EXPECT_DOUBLE_EQ(map.highest(), 9);
  EXPECT_FALSE(map.IsCellKnown(2, 2));
  EXPECT_TRUE(map.IsCellKnown(3, 2));
}

TEST(HeightMap, KnowsAPlaceOnlyWithItsFourCellsAndInside) {
  std::vector<float> heights(16, 1.0F);
  heights[0] = kNan;
  const HeightMap map(MakeGrid(4, 4), heights);
  EXPECT_FALSE(map.IsKnown(10.9, -4.1));
  EXPECT_TRUE(map.IsKnown(11.1, -4.9));
  EXPECT_TRUE(map.IsKnown(13, -2));
  EXPECT_FALSE(map.IsKnown(13.01, -2));
  EXPECT_FALSE(map.IsKnown(9.99, -3));
  EXPECT_FALSE(map.IsKnown(std::nan(""), -3));
}

TEST(HeightMap, KnowsABoxOnlyWithAllPlacesInIt) {
  std::vector<float> heights(16, 1.0F);
  const HeightMap whole(MakeGrid(4, 4), heights);
  heights[0] = kNan;
  const HeightMap map(MakeGrid(4, 4), heights);
  EXPECT_TRUE(map.IsBoxKnown({11.1, -4.9}, {13, -2}));
  EXPECT_FALSE(map.IsBoxKnown({10.9, -4.1}, {13, -2}));
  EXPECT_TRUE(whole.IsBoxKnown({10, -5}, {13, -2}));
  EXPECT_FALSE(whole.IsBoxKnown({10, -5}, {13.01, -2}));
  EXPECT_FALSE(whole.IsBoxKnown({9.99, -5}, {13, -2}));
  EXPECT_FALSE(whole.IsBoxKnown({10, -5}, {std::nan(""), -2}));
}

// Hash-like bumps; the bound is compared with dense samples.
TEST(HeightMap, BoundIsNeverTooLow) {
  for (const double cell : {0.1, 0.7, 1.0, 5.0}) {
    const HeightMap::Grid grid = MakeGrid(60, 45, cell, 1.3 * cell);
    std::vector<float> heights;
    for (std::size_t i = 0; i < grid.CellCount(); ++i) {
      heights.push_back(static_cast<float>((i * 2654435761U >> 7) % 1000) / 100.0F);
    }
    const HeightMap map(grid, heights, 50);
    for (int k = 0; k < 40; ++k) {
      const double x = 9 + 1.7 * cell * k;
      const double y = -6 + 1.6 * cell * k;
      for (const double radius : {0.0, 0.4, 1.0, 3.3, 40.0}) {
        const double bound = map.HighestWithin(radius, x, y);
        for (double angle = 0; angle < 6.28; angle += 0.4) {
          for (const double share : {0.0, 0.5, 1.0}) {
            const double r = share * radius;
            EXPECT_GE(bound + 1e-9, map.Height(x + r * std::cos(angle), y + r * std::sin(angle)));
          }
        }
      }
    }
  }
}

TEST(HeightMap, BoundIsLocal) {
  std::vector<float> heights(100 * 100, 0.0F);
  heights[50 * 100 + 50] = 7;  // at x = 60, y = 45
  const HeightMap map(MakeGrid(100, 100), heights);
  EXPECT_DOUBLE_EQ(map.HighestWithin(0.4, 60, 45), 7);
  EXPECT_DOUBLE_EQ(map.HighestWithin(0.4, 63.5, 45), 0);
}

// Large enough for pages of 2 MB: 900 x 700 cells take 5 MB.
TEST(HeightMap, KeepsEveryCellOfALargeMap) {
  const HeightMap::Grid grid = MakeGrid(900, 700);
  std::vector<float> heights(grid.CellCount());
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = static_cast<float>(i % 9973);
  const HeightMap map(grid, heights);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const float stated = heights[static_cast<std::size_t>(row) * 900 + column];
      const Eigen::Vector2d center = grid.Center(column, row);
      ASSERT_EQ(map.CellHeight(column, row), stated);
      ASSERT_EQ(map.Height(center.x(), center.y()), stated) << column << ", " << row;
    }
  }
}

TEST(HeightMap, RefusesTooFewCells) {
  EXPECT_THAT(ErrorOf([] { HeightMap(MakeGrid(1, 5), std::vector<float>(5)); }),
              HasSubstr("at least 2 x 2"));
  EXPECT_THAT(ErrorOf([] { HeightMap(MakeGrid(2, 2), std::vector<float>(4, kNan)); }),
              HasSubstr("no cell"));
}

}  // namespace
}  // namespace dbd
