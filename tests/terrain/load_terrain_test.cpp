#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

std::shared_ptr<const Terrain> LoadElevation(const std::string& file) {
  TerrainFiles files;
  files.elevation = file;
  return LoadTerrain(files);
}

double HeightAtMap(const Terrain& terrain, double x, double y) {
  const Eigen::Vector2d local = terrain.frame().ToLocal({x, y});
  return terrain.Height(local.x(), local.y());
}

class LoadTerrainTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  TestRaster raster_;
};

TEST_F(LoadTerrainTest, PlacesCellCentres) {
  raster_.value = [](int column, int row) { return 10 * column + row; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  // The centre of column 2, row 0 (north) is half a cell in from the corner 500000, 5200000.
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999.5), 20, 1e-5);
  EXPECT_NEAR(HeightAtMap(*terrain, 500000.5, 5199997.5), 2, 1e-5);
  EXPECT_TRUE(terrain->frame().has_crs());
}

TEST_F(LoadTerrainTest, ReadsSouthUpRasters) {
  raster_.transform = {500000, 1, 0, 5200000, 0, 1};
  raster_.value = [](int, int row) { return row; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(HeightAtMap(*terrain, 500001, 5200002.5), 2, 1e-5);
}

TEST_F(LoadTerrainTest, ReadsCellsThatAreNotSquare) {
  raster_.transform = {500000, 2, 0, 5200000, 0, -5};
  raster_.value = [](int column, int row) { return column - row; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_EQ(terrain->heights().grid().cell_size, Eigen::Vector2d(2, 5));
  // Column 1 is at 500003, row 1 at 5199992.5.
  EXPECT_NEAR(HeightAtMap(*terrain, 500003, 5199992.5), 0, 1e-5);
}

TEST_F(LoadTerrainTest, KeepsNodataAndNotANumberUnknown) {
  raster_.has_nodata = true;
  raster_.nodata = -5;
  raster_.value = [](int column, int row) {
    if (row > 0) return 1.0;
    const double odd[] = {-5, std::nan(""), -9999, 3.4e38};
    return odd[column];
  };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_DOUBLE_EQ(terrain->heights().unknown_share(), 4.0 / 12.0);
  EXPECT_NEAR(HeightAtMap(*terrain, 500002, 5199999.5), 1, 1e-5);
  const Eigen::Vector2d place = terrain->frame().ToLocal({500002, 5199999});
  EXPECT_FALSE(terrain->IsKnown(place.x(), place.y()));
}

TEST_F(LoadTerrainTest, AppliesScaleOffsetAndUnit) {
  raster_.type = GDT_Int16;
  raster_.scale = 0.1;
  raster_.offset = 100;
  raster_.value = [](int, int) { return 250; };
  // 250 * 0.1 + 100 = 125.
  EXPECT_NEAR(LoadElevation(raster_.Write(directory_.File("a.tif")))->Height(0, 0), 125, 1e-5);
  raster_.unit = "ft";
  // 125 ft * 0.3048 = 38.1 m.
  EXPECT_NEAR(LoadElevation(raster_.Write(directory_.File("b.tif")))->Height(0, 0), 38.1, 1e-5);
}

TEST_F(LoadTerrainTest, KeepsMillimetresOnASummit) {
  raster_.type = GDT_Float64;
  raster_.value = [](int column, int) { return 8000 + 1e-4 * column; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999), 8000.0002, 1e-7);
}

TEST_F(LoadTerrainTest, UsesAPlainGridWithoutCrs) {
  raster_.crs = "";
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_FALSE(terrain->frame().has_crs());
  EXPECT_NEAR(HeightAtMap(*terrain, 500001.5, 5199999), 1, 1e-5);
}

TEST_F(LoadTerrainTest, ReadsTheBandThatWasChosen) {
  raster_.bands = 2;  // only the first has values, the second is all 0
  raster_.value = [](int, int) { return 7; };
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  files.elevation_band = 2;
  EXPECT_NEAR(LoadTerrain(files)->Height(0, 0), 0, 1e-5);
  files.elevation_band = 3;
  EXPECT_EQ(ErrorOf([&] { LoadTerrain(files); }), files.elevation + ": has no band 3, only 2");
}

TEST_F(LoadTerrainTest, ReadsHeightsInTheUnitOfTheVerticalSystem) {
  raster_.crs = "EPSG:32633+6360";  // NAVD88 height (ftUS)
  raster_.value = [](int, int) { return 3937; };
  // 3937 US survey feet are 1200 m by definition.
  EXPECT_NEAR(LoadElevation(raster_.Write(directory_.File("a.tif")))->Height(0, 0), 1200, 1e-3);
}

TEST_F(LoadTerrainTest, WarpsGridsInFeet) {
  raster_.columns = raster_.rows = 50;
  raster_.crs = "EPSG:2229";  // California zone 5 (ftUS)
  raster_.transform = {6500000, 10, 0, 1850000, 0, -10};
  raster_.unit = "ft";
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 3.048, 0.05);
  // Column 20 of heights in feet.
  const Eigen::Vector2d local = terrain->frame().FromSource({6500205, 1850000 - 255});
  EXPECT_NEAR(terrain->Height(local.x(), local.y()), 20 * 0.3048, 0.01);
}

TEST_F(LoadTerrainTest, ShiftsPixelIsPointByHalfACell) {
  raster_.value = [](int column, int) { return column; };
  raster_.is_point = true;
  raster_.Write(directory_.File("point.tif"));
  // Stored as the place of the first centre: GDAL moves the corner back by half a cell, so that
  // what was written as a corner reads the same.
  const auto terrain = LoadElevation(directory_.File("point.tif"));
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999.5), 2, 1e-5);
  CPLSetConfigOption("GTIFF_POINT_GEO_IGNORE", "TRUE");
  const auto ignored = LoadElevation(directory_.File("point.tif"));
  CPLSetConfigOption("GTIFF_POINT_GEO_IGNORE", nullptr);
  EXPECT_NEAR(ignored->frame().ToMap(ignored->heights().min_corner()).x() -
                  terrain->frame().ToMap(terrain->heights().min_corner()).x(),
              0.5, 1e-9);
}

TEST_F(LoadTerrainTest, TakesACoordinateSystemWhereTheFileHasNone) {
  raster_.crs = "";
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  EXPECT_FALSE(LoadTerrain(files)->frame().has_crs());
  files.crs = "EPSG:3794";
  EXPECT_THAT(LoadTerrain(files)->frame().CrsName(), HasSubstr("EPSG:3794"));
  files.crs = "EPSG:nonsense";
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("'EPSG:nonsense' for"));
}

TEST_F(LoadTerrainTest, JoinsRasters) {
  raster_.value = [](int column, int) { return column; };
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("west.tif"));
  raster_.transform[0] += raster_.columns;
  raster_.value = [](int column, int) { return 4 + column; };
  files.more_elevation = {raster_.Write(directory_.File("east.tif"))};
  const auto terrain = LoadTerrain(files);
  EXPECT_EQ(terrain->heights().grid().columns, 8);
  EXPECT_NEAR(HeightAtMap(*terrain, 500004, 5199999), 3.5, 1e-5);  // across the seam
  raster_.crs = "EPSG:32632";
  files.more_elevation = {raster_.Write(directory_.File("other.tif"))};
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("cannot be joined"));
  raster_.crs = "EPSG:32633";
  raster_.scale = 0.1;
  files.more_elevation = {raster_.Write(directory_.File("scaled.tif"))};
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("cannot be joined"));
  raster_.scale = 1;
  raster_.unit = "ft";
  files.more_elevation = {raster_.Write(directory_.File("feet.tif"))};
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("another scale"));
}

TEST_F(LoadTerrainTest, FillsHolesOnlyWhenAsked) {
  raster_.columns = raster_.rows = 9;
  raster_.value = [](int column, int row) {
    return column == 4 && row == 4 ? std::nan("") : 2.0 * column;
  };
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  const auto forbid = LoadTerrain(files);
  const Eigen::Vector2d hole = forbid->frame().ToLocal({500004.5, 5199995.5});
  EXPECT_FALSE(forbid->IsKnown(hole.x(), hole.y()));
  EXPECT_TRUE(forbid->notes().empty());
  files.unknown_ground = UnknownGround::kFill;
  const auto fill = LoadTerrain(files);
  EXPECT_TRUE(fill->IsKnown(hole.x(), hole.y()));
  // Between the heights on both sides.
  EXPECT_GT(fill->Height(hole.x(), hole.y()), 6);
  EXPECT_LT(fill->Height(hole.x(), hole.y()), 10);
  ASSERT_EQ(fill->notes().size(), 1U);
  EXPECT_THAT(fill->notes()[0], HasSubstr("1.23 %"));  // 1 of 81 cells
}

TEST_F(LoadTerrainTest, WarpsGeographicRasters) {
  raster_.columns = raster_.rows = 120;
  raster_.transform = {14.5, 1e-5, 0, 46.5, 0, -1e-5};
  raster_.crs = "EPSG:4326";
  raster_.value = [](int column, int row) { return column * 0.5 + row * 0.25; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  EXPECT_THAT(terrain->frame().CrsName(), HasSubstr("EPSG:32633"));
  // Column 40, row 70 lies at 14.5 + 40.5e-5, 46.5 - 70.5e-5; its height is 20 + 17.5.
  const Eigen::Vector2d local = terrain->frame().FromSource({14.5 + 40.5e-5, 46.5 - 70.5e-5});
  EXPECT_NEAR(terrain->Height(local.x(), local.y()), 37.5, 0.05);
  EXPECT_LT((local - terrain->frame().FromWgs84({14.5 + 40.5e-5, 46.5 - 70.5e-5})).norm(), 1e-3);
  // One cell is 0.77 m by 1.11 m; cells become square at about this size.
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 0.95, 0.2);
  EXPECT_TRUE(terrain->IsKnown(local.x(), local.y()));
}

TEST_F(LoadTerrainTest, WarpsMapsThatStretchTheGround) {
  raster_.columns = raster_.rows = 60;
  raster_.crs = "EPSG:3857";
  raster_.transform = {1600000, 10, 0, 5800000, 0, -10};
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevation(raster_.Write(directory_.File("a.tif")));
  // At 46 degrees north Web Mercator shows 1 m as 1 / cos(46 deg) = 1.44 m: a cell is 6.9 m.
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 6.9, 0.2);
}

TEST_F(LoadTerrainTest, RefusesWithOneLine) {
  const std::string file = directory_.File("a.tif");
  const auto message = [&] { return ErrorOf([&] { LoadElevation(raster_.Write(file)); }); };
  raster_.bands = 2;
  EXPECT_EQ(message(), file + ": holds 2 bands, one must be chosen");
  raster_ = {};
  raster_.type = GDT_CFloat32;
  EXPECT_THAT(message(), HasSubstr("complex"));
  raster_ = {};
  raster_.transform = {500000, 1, 0.2, 5200000, 0.2, -1};
  EXPECT_THAT(message(), HasSubstr("rotated"));
  raster_ = {};
  raster_.transform = {};
  EXPECT_THAT(message(), HasSubstr("no georeference"));
  raster_ = {};
  raster_.columns = 1;
  EXPECT_THAT(message(), HasSubstr("at least 2 x 2"));
  raster_ = {};
  raster_.value = [](int, int) { return std::nan(""); };
  EXPECT_THAT(message(), HasSubstr("every cell is nodata"));
}

TEST_F(LoadTerrainTest, RefusesWhatIsNoRaster) {
  EXPECT_EQ(ErrorOf([] { LoadElevation("/does/not/exist.tif"); }),
            "/does/not/exist.tif: no such file");
  EXPECT_THAT(ErrorOf([&] { LoadElevation(directory_.path().string()); }), HasSubstr("directory"));
  const std::string text = directory_.Write("a.tif", "hello");
  testing::internal::CaptureStderr();
  EXPECT_THAT(ErrorOf([&] { LoadElevation(text); }), HasSubstr("cannot be read as a raster"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadTerrainTest, RefusesTruncatedRasters) {
  raster_.columns = raster_.rows = 100;
  const std::string file = raster_.Write(directory_.File("a.tif"));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  testing::internal::CaptureStderr();
  EXPECT_THAT(ErrorOf([&] { LoadElevation(file); }), HasSubstr(file));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadTerrainTest, RefusesWhatDoesNotFitIntoMemory) {
  const std::string file = directory_.Write(
      "huge.vrt",
      "<VRTDataset rasterXSize=\"200000\" rasterYSize=\"200000\"><GeoTransform>0,1,0,0,0,-1"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>");
  EXPECT_THAT(ErrorOf([&] { LoadElevation(file); }), HasSubstr("GB of memory"));
}

TEST_F(LoadTerrainTest, CutsWhatIsTooLargeToAWindowRoundThePlaces) {
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

TEST_F(LoadTerrainTest, CutsTheRightWindow) {
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
    const auto terrain = LoadElevation(SharedFile(real.file));
    EXPECT_EQ(terrain->heights().grid().columns, real.columns) << real.file;
    EXPECT_EQ(terrain->heights().grid().rows, real.rows) << real.file;
    EXPECT_NEAR(terrain->heights().lowest(), real.lowest, 0.01) << real.file;
    EXPECT_NEAR(terrain->heights().highest(), real.highest, 0.01) << real.file;
  }
  EXPECT_NEAR(LoadElevation(SharedFile("dem/avaAlr_5m_holes.tif"))->heights().unknown_share(),
              0.306, 0.001);
}

TEST(LoadTerrain, WarpsARealGeographicRaster) {
  const std::string file = SharedFile("dem/tahoe_lidar_bareearth.tif");
  if (file.empty()) GTEST_SKIP() << "no shared data";
  const auto terrain = LoadElevation(file);
  EXPECT_NEAR(terrain->heights().lowest(), 2495.4, 0.1);
  EXPECT_NEAR(terrain->heights().highest(), 2526.95, 0.1);
  // 400 x 0.47 m by 400 x 0.61 m.
  const HeightMap::Grid& grid = terrain->heights().grid();
  EXPECT_NEAR(grid.columns * grid.cell_size.x(), 193, 6);
  EXPECT_NEAR(grid.rows * grid.cell_size.y(), 246, 6);
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
  const HeightMap::Grid& grid = obstacles.grid();
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
    const std::string message = ErrorOf([&] { LoadElevation(entry.path().string()); });
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
