#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class MapWindowTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  TestRaster raster_;
};

TEST_F(MapWindowTest, CutsWhatIsTooLargeToAWindowRoundThePlaces) {
  TerrainFiles files;
  files.elevation = directory_.Write(
      "map.vrt",
      "<VRTDataset rasterXSize=\"3000\" rasterYSize=\"2000\"><GeoTransform>0,1,0,2000,0,-1"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>");
  files.memory_limit = 1e6 * 2 * 21;  // 21 bytes a cell, half of it for heights: 1e6 cells
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("3000 x 2000 cells need 0.13 GB"));
  files.places = {{1000.5, 500.5}, {1100.5, 700.5}};
  const auto terrain = LoadTerrain(files);
  const HeightMap& heights = terrain->heights();
  EXPECT_LE(heights.grid().CellCount(), 1'000'000U);
  EXPECT_GE(heights.grid().CellCount(), 900'000U);
  for (const Eigen::Vector2d& place : files.places) {
    const Eigen::Vector2d local = terrain->frame().ToLocal(place);
    EXPECT_TRUE(terrain->IsKnown(local.x(), local.y()));
  }
  EXPECT_THAT(terrain->notes().at(0), HasSubstr("of 3000 x 2000 cells a window"));
  files.places.push_back({2900, 1900});
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("are allowed"));
}

TEST_F(MapWindowTest, CutsTheRightWindow) {
  raster_.columns = 1500;
  raster_.rows = 1200;
  raster_.type = GDT_Int16;
  raster_.Write(directory_.File("a.tif"));
  {
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(directory_.File("a.tif").c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
    double height = 77;  // column 900, row 300
    ASSERT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 900, 300, 1, 1, &height, 1, 1,
                                                  GDT_Float64, 0, 0, nullptr),
              CE_None);
  }
  TerrainFiles files;
  files.elevation = directory_.File("a.tif");
  files.memory_limit = 1e6 * 2 * 21;
  files.places = {{500900.5, 5199699.5}};
  const auto terrain = LoadTerrain(files);
  EXPECT_LT(terrain->heights().grid().columns, 1100);
  EXPECT_NEAR(HeightAtMap(*terrain, 500900.5, 5199699.5), 77, 1e-4);
  EXPECT_NEAR(HeightAtMap(*terrain, 500901.5, 5199699.5), 0, 1e-4);
}

TEST_F(MapWindowTest, TakesPlacesInDegreesToo) {
  raster_.columns = 1500;
  raster_.rows = 600;
  raster_.type = GDT_Byte;
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  files.memory_limit = 8e5 * 2 * 21;
  // On the central meridian of zone 33, easting 500000; 5200000 m north is 46.9528 deg on it.
  files.places = {{500300.5, 5199699.5}};
  files.wgs84_places = {{15.001, 46.949}};
  const auto terrain = LoadTerrain(files);
  EXPECT_LT(terrain->heights().grid().columns, 1400);
  const Eigen::Vector2d place = terrain->frame().FromWgs84({15.001, 46.949});
  EXPECT_TRUE(terrain->IsKnown(place.x(), place.y()));
}

TEST_F(MapWindowTest, TellsTheNeedBeforeTheFirstRowAndThenTheRows) {
  raster_.columns = 2000;
  raster_.rows = 500;
  raster_.type = GDT_Byte;
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  std::vector<int> rows;
  LoadTerrain(files, [&rows](const std::string& stage, int done, int total) {
    EXPECT_EQ(stage, "elevation, 0.02 GB, row");  // 1e6 cells of 21 bytes
    EXPECT_EQ(total, 500);
    rows.push_back(done);
  });
  EXPECT_EQ(rows.front(), 0);
  EXPECT_EQ(rows.back(), 500);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_LE(rows.size(), 101U);
}

}  // namespace
}  // namespace dbd
