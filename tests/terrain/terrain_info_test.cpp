#include <dbd/terrain/terrain_info.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace dbd {
namespace {

TEST(TerrainInfo, DescribesASlope) {
  const HeightMap::Grid grid = {5, 4, {0, 0}, {2, 2}};
  std::vector<float> heights;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      heights.push_back(static_cast<float>(2 * column));  // 45 degrees
    }
  }
  heights.back() = std::numeric_limits<float>::quiet_NaN();
  const Terrain terrain(LocalFrame("", {100, 200}), HeightMap(grid, heights),
                        MaterialMap(MaterialTable::Load("basic").GetName("gravel")), {});
  const TerrainInfo info = DescribeTerrain(terrain);
  EXPECT_EQ(info.extent, Eigen::Vector2d(10, 8));
  EXPECT_EQ(info.map_min, Eigen::Vector2d(99, 199));
  EXPECT_EQ(info.file_south_west, info.map_min);
  EXPECT_EQ(info.file_north_east, Eigen::Vector2d(109, 207));
  EXPECT_NEAR(info.median_slope, std::numbers::pi / 4, 1e-6);
  EXPECT_NEAR(info.steepest_slope, std::numbers::pi / 4, 1e-6);
  EXPECT_DOUBLE_EQ(info.unknown_share, 1.0 / 20);
  EXPECT_EQ(info.highest, 8);
  ASSERT_EQ(info.materials.size(), 1U);
  EXPECT_EQ(info.materials[0].name, "gravel");
  EXPECT_EQ(info.crs_name, "");
  EXPECT_FALSE(info.has_obstacles);
}

TEST(TerrainInfo, StatesTheCornersInTheCoordinatesOfTheFileToo) {
  LocalFrame frame("EPSG:32633", {500000, 5200000});
  frame.set_source_wkt("EPSG:4326");
  const Terrain terrain(frame, HeightMap({5, 4, {0, 0}, {2, 2}}, std::vector<float>(20)),
                        MaterialMap(MaterialTable::Load("basic").GetName("gravel")), {});
  const TerrainInfo info = DescribeTerrain(terrain);
  EXPECT_EQ(info.map_min, Eigen::Vector2d(499999, 5199999));
  EXPECT_EQ(info.crs_name, "WGS 84 / UTM zone 33N (EPSG:32633)");
  EXPECT_EQ(info.file_crs_name, "WGS 84 (EPSG:4326)");
  EXPECT_NEAR(info.file_south_west.x(), 15, 2e-5);  // 1 m west of the zone's meridian
  EXPECT_LT(info.file_south_west.x(), 15);
  EXPECT_LT((frame.FromSource(info.file_north_east) - Eigen::Vector2d(9, 7)).norm(), 1e-6);
  EXPECT_GT(info.file_north_east.y(), info.file_south_west.y());
}

}  // namespace
}  // namespace dbd
