#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class LoadTerrainTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  TestRaster raster_;
};

TEST_F(LoadTerrainTest, ResamplesClassesOfAnotherGrid) {
  raster_.columns = raster_.rows = 40;
  const std::string elevation = raster_.Write(directory_.File("dem.tif"));
  TestRaster classes;
  classes.type = GDT_Byte;
  classes.columns = classes.rows = 30;
  classes.crs = "EPSG:32632";
  const LocalFrame zone_33("EPSG:32633", {0, 0});
  const LocalFrame zone_32("EPSG:32632", {0, 0});
  const Eigen::Vector2d corner = zone_32.FromWgs84(zone_33.ToWgs84({500000, 5200000}));
  classes.transform = {corner.x() - 20, 4, 0, corner.y() + 20, 0, -4};
  classes.value = [](int column, int row) { return column == 8 && row == 9 ? 10 : 4; };
  TerrainFiles files;
  files.elevation = elevation;
  files.materials = classes.Write(directory_.File("classes.tif"));
  const auto terrain = LoadTerrain(files);
  // Column 8, row 9 has its centre 14 m east and 18 m south of the corner in zone 32.
  const Eigen::Vector2d water =
      zone_33.FromWgs84(zone_32.ToWgs84(corner + Eigen::Vector2d(14, -18)));
  const Eigen::Vector2d local = terrain->frame().ToLocal(water);
  ASSERT_NE(terrain->materials().At(local.x(), local.y()), nullptr);
  EXPECT_EQ(terrain->materials().At(local.x(), local.y())->name, "water");
  EXPECT_EQ(terrain->materials().At(local.x() + 6, local.y())->name, "firm-soil");
}

TEST_F(LoadTerrainTest, RefusesClassesThatTheTableLacks) {
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("dem.tif"));
  raster_.type = GDT_Byte;
  raster_.value = [](int column, int row) { return column == 3 && row == 2 ? 77 : 4; };
  files.materials = raster_.Write(directory_.File("classes.tif"));
  EXPECT_EQ(
      ErrorOf([&] { LoadTerrain(files); }),
      files.materials + ": class 77 at 500003.5, 5199997.5 is not in the material table 'basic'");
  raster_.type = GDT_Float32;
  files.materials = raster_.Write(directory_.File("floats.tif"));
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("holds Float32"));
}

TEST_F(LoadTerrainTest, ReadsClassesFromTheBandThatWasChosen) {
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("dem.tif"));
  raster_.type = GDT_Byte;
  raster_.bands = 2;
  raster_.value = [](int, int) { return 4; };
  files.materials = raster_.Write(directory_.File("classes.tif"));
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("2 bands"));
  files.materials_band = 1;
  EXPECT_EQ(LoadTerrain(files)->materials().At(0, 0)->name, "firm-soil");
}

TEST_F(LoadTerrainTest, RefusesClassesElsewhere) {
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("dem.tif"));
  raster_.type = GDT_Byte;
  raster_.transform = {600000, 1, 0, 5200000, 0, -1};
  files.materials = raster_.Write(directory_.File("classes.tif"));
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("overlap"));
}

TEST_F(LoadTerrainTest, LooksUpTheDefaultMaterial) {
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("dem.tif"));
  EXPECT_DOUBLE_EQ(LoadTerrain(files)->Soil(0, 0).cone_index, 1.8e6);
  files.default_material = "soft-sail";
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("nearest is 'soft-soil'"));
}

struct RealRaster {
  const char* file;
  int columns;
  int rows;
  double lowest;
  double highest;
};

// Size and range as the data's own notes state them.
TEST(LoadTerrain, ReadsRealRasters) {
  const RealRaster rasters[] = {
      {"dem/slovenia_TM1_564_146.tif", 1000, 1000, 254.97, 325.05},
      {"dem/gabilan_1m.tif", 921, 859, 187.9, 307.28},
      {"dem/gabilan.bil", 921, 859, 187.9, 307.28},
      {"dem/avaAlr_5m_holes.tif", 417, 915, 566.127, 2452.32},
      {"dem/hugo_site_10m.asc", 76, 55, 1660, 1711},
      {"dem/edge/bell_southup.tif", 250, 250, 200, 600},
  };
  if (SharedFile(rasters[0].file).empty()) GTEST_SKIP() << "no shared data";
  for (const RealRaster& real : rasters) {
    const auto terrain = LoadElevationOnly(SharedFile(real.file));
    EXPECT_EQ(terrain->heights().grid().columns, real.columns) << real.file;
    EXPECT_EQ(terrain->heights().grid().rows, real.rows) << real.file;
    EXPECT_NEAR(terrain->heights().lowest(), real.lowest, 0.01) << real.file;
    EXPECT_NEAR(terrain->heights().highest(), real.highest, 0.01) << real.file;
  }
  EXPECT_NEAR(LoadElevationOnly(SharedFile("dem/avaAlr_5m_holes.tif"))->heights().unknown_share(),
              0.306, 0.001);
}

TEST(LoadTerrain, WarpsARealGeographicRaster) {
  const std::string file = SharedFile("dem/tahoe_lidar_bareearth.tif");
  if (file.empty()) GTEST_SKIP() << "no shared data";
  const auto terrain = LoadElevationOnly(file);
  EXPECT_NEAR(terrain->heights().lowest(), 2495.4, 0.1);
  EXPECT_NEAR(terrain->heights().highest(), 2526.95, 0.1);
  // 400 x 0.47 m by 400 x 0.61 m.
  const HeightMap::Grid& grid = terrain->heights().grid();
  EXPECT_NEAR(grid.columns * grid.cell_size.x(), 193, 6);
  EXPECT_NEAR(grid.rows * grid.cell_size.y(), 246, 6);
}

TEST(LoadTerrain, SaysWhatToConvertPointCloudsTo) {
  for (const char* name : {"a.las", "a.LAZ", "a.pcd"}) {
    TerrainFiles files;
    files.elevation = name;
    EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("ground points to XYZ")) << name;
    files.elevation = "dem.tif";
    files.obstacles = name;
    EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("to an OctoMap")) << name;
    files.obstacles.clear();
    files.surface_model = name;
    EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("highest points")) << name;
  }
}

TEST(LoadTerrain, ReadsACoRegisteredRealSet) {
  TerrainFiles files;
  files.elevation = SharedFile("dem/lidr_topography_dtm_1m.tif");
  if (files.elevation.empty()) GTEST_SKIP() << "no shared data";
  files.materials = SharedFile("landcover/lidr_topography_material_1m.tif");
  files.material_table = "forest-ponds";
  files.obstacles = SharedFile("octomap/lidr_topography_obstacles_0.5m.bt");
  files.obstacles_placement.origin = {273357, 5274357};
  const auto terrain = LoadTerrain(files);
  EXPECT_NEAR(terrain->materials().Share(MaterialMap::kNone), 0.00175, 1e-4);
  // Most of what trees fill lies over the canopy class.
  const ObstacleMap& obstacles = terrain->obstacles();
  const HeightMap::Grid& grid = obstacles.layers().front().grid();
  int open = 0;
  int canopy = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d place = grid.Center(column, row);
      const Material* material = terrain->materials().At(place.x(), place.y());
      if (material == nullptr || !obstacles.Blocks(place.x(), place.y(), 20)) continue;
      open += material->name == "open-ground";
      canopy += material->name == "canopy";
    }
  }
  EXPECT_GT(canopy, 3 * open);
  EXPECT_GT(obstacles.BlockedShare(2.0), 0.001);
}

TEST(LoadTerrain, SurvivesEveryMalformedFile) {
  const std::string directory = SharedFile("malformed");
  if (directory.empty()) GTEST_SKIP() << "no shared data";
  testing::internal::CaptureStderr();
  int refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    const std::string message = ErrorOf([&] { LoadElevationOnly(entry.path().string()); });
    if (message.empty()) continue;
    ++refused;
    EXPECT_THAT(message, HasSubstr(entry.path().filename().string()));
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace dbd
