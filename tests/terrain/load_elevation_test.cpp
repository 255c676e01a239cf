#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class LoadElevationTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  TestRaster raster_;
};

TEST_F(LoadElevationTest, PlacesCellCentres) {
  raster_.value = [](int column, int row) { return 10 * column + row; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  // The centre of column 2, row 0 (north) is half a cell in from the corner 500000, 5200000.
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999.5), 20, 1e-5);
  EXPECT_NEAR(HeightAtMap(*terrain, 500000.5, 5199997.5), 2, 1e-5);
  EXPECT_TRUE(terrain->frame().has_crs());
}

TEST_F(LoadElevationTest, ReadsSouthUpRasters) {
  raster_.transform = {500000, 1, 0, 5200000, 0, 1};
  raster_.value = [](int, int row) { return row; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(HeightAtMap(*terrain, 500001, 5200002.5), 2, 1e-5);
}

TEST_F(LoadElevationTest, ReadsCellsThatAreNotSquare) {
  raster_.transform = {500000, 2, 0, 5200000, 0, -5};
  raster_.value = [](int column, int row) { return column - row; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_EQ(terrain->heights().grid().cell_size, Eigen::Vector2d(2, 5));
  // Column 1 is at 500003, row 1 at 5199992.5.
  EXPECT_NEAR(HeightAtMap(*terrain, 500003, 5199992.5), 0, 1e-5);
}

TEST_F(LoadElevationTest, KeepsNodataAndNotANumberUnknown) {
  raster_.has_nodata = true;
  raster_.nodata = -5;
  raster_.value = [](int column, int row) {
    if (row > 0) return 1.0;
    const double odd[] = {-5, std::nan(""), -9999, 3.4e38};
    return odd[column];
  };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_DOUBLE_EQ(terrain->heights().unknown_share(), 4.0 / 12.0);
  EXPECT_NEAR(HeightAtMap(*terrain, 500002, 5199999.5), 1, 1e-5);
  const Eigen::Vector2d place = terrain->frame().ToLocal({500002, 5199999});
  EXPECT_FALSE(terrain->IsKnown(place.x(), place.y()));
}

TEST_F(LoadElevationTest, AppliesScaleOffsetAndUnit) {
  raster_.type = GDT_Int16;
  raster_.scale = 0.1;
  raster_.offset = 100;
  raster_.value = [](int, int) { return 250; };
  // 250 * 0.1 + 100 = 125.
  EXPECT_NEAR(LoadElevationOnly(raster_.Write(directory_.File("a.tif")))->Height(0, 0), 125, 1e-5);
  raster_.unit = "ft";
  // 125 ft * 0.3048 = 38.1 m.
  EXPECT_NEAR(LoadElevationOnly(raster_.Write(directory_.File("b.tif")))->Height(0, 0), 38.1, 1e-5);
}

TEST_F(LoadElevationTest, KeepsMillimetresOnASummit) {
  raster_.type = GDT_Float64;
  raster_.value = [](int column, int) { return 8000 + 1e-4 * column; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999), 8000.0002, 1e-7);
}

TEST_F(LoadElevationTest, UsesAPlainGridWithoutCrs) {
  raster_.crs = "";
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_FALSE(terrain->frame().has_crs());
  EXPECT_NEAR(HeightAtMap(*terrain, 500001.5, 5199999), 1, 1e-5);
}

TEST_F(LoadElevationTest, ReadsTheBandThatWasChosen) {
  raster_.bands = 2;  // only the first has values, the second is all 0
  raster_.value = [](int, int) { return 7; };
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  files.elevation_band = 2;
  EXPECT_NEAR(LoadTerrain(files)->Height(0, 0), 0, 1e-5);
  files.elevation_band = 3;
  EXPECT_EQ(ErrorOf([&] { LoadTerrain(files); }), files.elevation + ": has no band 3, only 2");
}

TEST_F(LoadElevationTest, ReadsHeightsInTheUnitOfTheVerticalSystem) {
  raster_.crs = "EPSG:32633+6360";  // NAVD88 height (ftUS)
  raster_.value = [](int, int) { return 3937; };
  // 3937 US survey feet are 1200 m by definition.
  EXPECT_NEAR(LoadElevationOnly(raster_.Write(directory_.File("a.tif")))->Height(0, 0), 1200, 1e-3);
}

TEST_F(LoadElevationTest, WarpsGridsInFeet) {
  raster_.columns = raster_.rows = 50;
  raster_.crs = "EPSG:2229";  // California zone 5 (ftUS)
  raster_.transform = {6500000, 10, 0, 1850000, 0, -10};
  raster_.unit = "ft";
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 3.048, 0.05);
  // Column 20 of heights in feet.
  const Eigen::Vector2d local = terrain->frame().FromSource({6500205, 1850000 - 255});
  EXPECT_NEAR(terrain->Height(local.x(), local.y()), 20 * 0.3048, 0.01);
}

TEST_F(LoadElevationTest, ShiftsPixelIsPointByHalfACell) {
  raster_.value = [](int column, int) { return column; };
  raster_.is_point = true;
  raster_.Write(directory_.File("point.tif"));
  // Stored as the place of the first centre: GDAL moves the corner back by half a cell, so that
  // what was written as a corner reads the same.
  const auto terrain = LoadElevationOnly(directory_.File("point.tif"));
  EXPECT_NEAR(HeightAtMap(*terrain, 500002.5, 5199999.5), 2, 1e-5);
  CPLSetConfigOption("GTIFF_POINT_GEO_IGNORE", "TRUE");
  const auto ignored = LoadElevationOnly(directory_.File("point.tif"));
  CPLSetConfigOption("GTIFF_POINT_GEO_IGNORE", nullptr);
  EXPECT_NEAR(ignored->frame().ToMap(ignored->heights().min_corner()).x() -
                  terrain->frame().ToMap(terrain->heights().min_corner()).x(),
              0.5, 1e-9);
}

TEST_F(LoadElevationTest, TakesACoordinateSystemWhereTheFileHasNone) {
  raster_.crs = "";
  TerrainFiles files;
  files.elevation = raster_.Write(directory_.File("a.tif"));
  EXPECT_FALSE(LoadTerrain(files)->frame().has_crs());
  files.crs = "EPSG:3794";
  EXPECT_THAT(LoadTerrain(files)->frame().CrsName(), HasSubstr("EPSG:3794"));
  files.crs = "EPSG:nonsense";
  EXPECT_THAT(ErrorOf([&] { LoadTerrain(files); }), HasSubstr("'EPSG:nonsense' for"));
}

TEST_F(LoadElevationTest, JoinsRasters) {
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

TEST_F(LoadElevationTest, FillsHolesOnlyWhenAsked) {
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

TEST_F(LoadElevationTest, WarpsGeographicRasters) {
  raster_.columns = raster_.rows = 120;
  raster_.transform = {14.5, 1e-5, 0, 46.5, 0, -1e-5};
  raster_.crs = "EPSG:4326";
  raster_.value = [](int column, int row) { return column * 0.5 + row * 0.25; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  EXPECT_THAT(terrain->frame().CrsName(), HasSubstr("EPSG:32633"));
  // Column 40, row 70 lies at 14.5 + 40.5e-5, 46.5 - 70.5e-5; its height is 20 + 17.5.
  const Eigen::Vector2d local = terrain->frame().FromSource({14.5 + 40.5e-5, 46.5 - 70.5e-5});
  EXPECT_NEAR(terrain->Height(local.x(), local.y()), 37.5, 0.05);
  EXPECT_LT((local - terrain->frame().FromWgs84({14.5 + 40.5e-5, 46.5 - 70.5e-5})).norm(), 1e-3);
  // One cell is 0.77 m by 1.11 m; cells become square at about this size.
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 0.95, 0.2);
  EXPECT_TRUE(terrain->IsKnown(local.x(), local.y()));
}

TEST_F(LoadElevationTest, WarpsMapsThatStretchTheGround) {
  raster_.columns = raster_.rows = 60;
  raster_.crs = "EPSG:3857";
  raster_.transform = {1600000, 10, 0, 5800000, 0, -10};
  raster_.value = [](int column, int) { return column; };
  const auto terrain = LoadElevationOnly(raster_.Write(directory_.File("a.tif")));
  // At 46 degrees north Web Mercator shows 1 m as 1 / cos(46 deg) = 1.44 m: a cell is 6.9 m.
  EXPECT_NEAR(terrain->heights().grid().cell_size.x(), 6.9, 0.2);
}

TEST_F(LoadElevationTest, RefusesWithOneLine) {
  const std::string file = directory_.File("a.tif");
  const auto message = [&] { return ErrorOf([&] { LoadElevationOnly(raster_.Write(file)); }); };
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

TEST_F(LoadElevationTest, RefusesWhatIsNoRaster) {
  EXPECT_EQ(ErrorOf([] { LoadElevationOnly("/does/not/exist.tif"); }),
            "/does/not/exist.tif: no such file");
  EXPECT_THAT(ErrorOf([&] { LoadElevationOnly(directory_.path().string()); }),
              HasSubstr("directory"));
  const std::string text = directory_.Write("a.tif", "hello");
  testing::internal::CaptureStderr();
  EXPECT_THAT(ErrorOf([&] { LoadElevationOnly(text); }), HasSubstr("cannot be read as a raster"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadElevationTest, RefusesTruncatedRasters) {
  raster_.columns = raster_.rows = 100;
  const std::string file = raster_.Write(directory_.File("a.tif"));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  testing::internal::CaptureStderr();
  EXPECT_THAT(ErrorOf([&] { LoadElevationOnly(file); }), HasSubstr(file));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadElevationTest, RefusesWhatDoesNotFitIntoMemory) {
  const std::string file = directory_.Write(
      "huge.vrt",
      "<VRTDataset rasterXSize=\"200000\" rasterYSize=\"200000\"><GeoTransform>0,1,0,0,0,-1"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>");
  EXPECT_THAT(ErrorOf([&] { LoadElevationOnly(file); }), HasSubstr("GB of memory"));
}

}  // namespace
}  // namespace dbd
