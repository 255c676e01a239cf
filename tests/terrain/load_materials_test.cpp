#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

// 4 x 3 cells of 1 m with the corner 500000, 5200000 in EPSG:32633.
class LoadMaterialsTest : public testing::Test {
 protected:
  void SetUp() override { files_.elevation = TestRaster().Write(directory_.File("dem.tif")); }

  // A square from 1 to 3 m east and 0 to 2 m south of the corner, with this attribute.
  std::string Square(const std::string& attribute) {
    return directory_.Write("areas.geojson", R"({"type": "FeatureCollection",
      "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32633"}},
      "features": [{"type": "Feature", "properties": {)" +
                                                 attribute +
                                                 R"(}, "geometry": {"type": "Polygon",
      "coordinates": [[[500001, 5199998], [500003, 5199998], [500003, 5200000],
                       [500001, 5200000], [500001, 5199998]]]}}]})");
  }

  std::string NameAt(const Terrain& terrain, double east, double south) {
    const Eigen::Vector2d local = terrain.frame().ToLocal({500000 + east, 5200000 - south});
    const Material* material = terrain.materials().At(local.x(), local.y());
    return material != nullptr ? material->name : "";
  }

  std::string Message() {
    return ErrorOf([this] { LoadTerrain(files_); });
  }

  TemporaryDirectory directory_;
  TerrainFiles files_;
};

TEST_F(LoadMaterialsTest, BurnsPolygonsByClassNumber) {
  files_.materials = Square("\"code\": 10");
  const auto terrain = LoadTerrain(files_);
  EXPECT_EQ(NameAt(*terrain, 1.5, 0.5), "water");
  EXPECT_EQ(NameAt(*terrain, 2.5, 1.5), "water");
  EXPECT_EQ(NameAt(*terrain, 0.5, 0.5), "");
  EXPECT_EQ(NameAt(*terrain, 1.5, 2.5), "");
  EXPECT_DOUBLE_EQ(terrain->materials().Share(MaterialMap::kNone), 8.0 / 12);
}

TEST_F(LoadMaterialsTest, BurnsPolygonsByMaterialName) {
  files_.materials = Square("\"soil\": \"Gravel\"");
  EXPECT_THAT(Message(), HasSubstr("no attribute class"));
  files_.material_field = "soil";
  EXPECT_EQ(NameAt(*LoadTerrain(files_), 1.5, 0.5), "gravel");
  files_.material_field = "ground";
  EXPECT_THAT(Message(), HasSubstr("no attribute 'ground'"));
  files_.materials = Square("\"class\": \"lava\"");
  files_.material_field.clear();
  EXPECT_THAT(Message(), HasSubstr("class 'lava' is neither"));
}

TEST_F(LoadMaterialsTest, ConvertsPolygonsToTheMap) {
  const LocalFrame map("EPSG:32633", {0, 0});
  std::string ring;
  for (const auto& [x, y] : {std::pair{500000.9, 5199997.9},
                             {500003.1, 5199997.9},
                             {500003.1, 5200000.1},
                             {500000.9, 5199997.9}}) {
    const Eigen::Vector2d lon_lat = map.ToWgs84({x, y});
    char text[80];
    std::snprintf(text, sizeof text, "%s[%.12f, %.12f]", ring.empty() ? "" : ", ", lon_lat.x(),
                  lon_lat.y());
    ring += text;
  }
  files_.materials = directory_.Write("a.geojson", R"({"type": "Feature", "properties":
      {"class": 3}, "geometry": {"type": "Polygon", "coordinates": [[)" +
                                                       ring + "]]}}");
  const auto terrain = LoadTerrain(files_);
  EXPECT_EQ(NameAt(*terrain, 2.5, 1.5), "gravel");  // below the diagonal
  EXPECT_EQ(NameAt(*terrain, 1.5, 0.5), "");
}

TEST_F(LoadMaterialsTest, TakesTheUnknownMaterialWhereThereIsNoKnownClass) {
  files_.materials = Square("\"code\": 77");
  EXPECT_THAT(Message(), HasSubstr("class 77 at"));
  files_.unknown_material = "tilled-soil";
  const auto terrain = LoadTerrain(files_);
  EXPECT_EQ(NameAt(*terrain, 1.5, 0.5), "tilled-soil");
  EXPECT_EQ(NameAt(*terrain, 0.5, 0.5), "tilled-soil");
  ASSERT_EQ(terrain->notes().size(), 1U);
  EXPECT_THAT(terrain->notes()[0], HasSubstr("100 %"));
  files_.unknown_material = "tiled-soil";
  EXPECT_THAT(Message(), HasSubstr("nearest is 'tilled-soil'"));
}

TEST_F(LoadMaterialsTest, TakesTheStateOfTheSoils) {
  const double moist = LoadTerrain(files_)->Soil(0, 0).cone_index;  // firm-soil everywhere
  EXPECT_DOUBLE_EQ(moist, 1800e3);
  files_.moisture = MoistureState::kWet;
  EXPECT_NEAR(LoadTerrain(files_)->Soil(0, 0).cone_index, 0.42403 * moist, 100);
  files_.material_table = "nlcd";
  files_.materials = Square("\"class\": 41");
  EXPECT_THAT(Message(), HasSubstr("moisture changes nothing"));
}

TEST_F(LoadMaterialsTest, NamesEveryClassThatTheTableLacks) {
  TestRaster classes;
  classes.type = GDT_Byte;
  classes.value = [](int column, int) { return 74 + column; };
  files_.materials = classes.Write(directory_.File("classes.tif"));
  EXPECT_THAT(Message(), HasSubstr("class 74 at"));
  EXPECT_THAT(Message(), HasSubstr("nor are 75, 76, 77"));
}

TEST_F(LoadMaterialsTest, RefusesPolygonsElsewhere) {
  files_.materials = directory_.Write("a.geojson", R"({"type": "Feature", "properties":
      {"class": 3}, "geometry": {"type": "Polygon",
      "coordinates": [[[14, 46], [14.1, 46], [14.1, 46.1], [14, 46]]]}})");
  EXPECT_THAT(Message(), HasSubstr("overlap"));
  files_.materials = directory_.Write("b.geojson", R"({"type": "Feature", "properties":
      {"class": 3}, "geometry": {"type": "Point", "coordinates": [14, 46]}})");
  EXPECT_THAT(Message(), HasSubstr("holds no areas"));
}

TEST(LoadMaterials, ReadsRealLandCover) {
  TerrainFiles files;
  files.elevation = SharedFile("landcover/lcp_elevation_30m.tif");
  if (files.elevation.empty()) GTEST_SKIP() << "no shared data";
  files.materials = SharedFile("landcover/lcp_landfire_8band_30m.tif");
  files.materials_band = 4;
  files.material_table = "fbfm40";
  EXPECT_DOUBLE_EQ(LoadTerrain(files)->materials().Share(MaterialMap::kNone), 0);

  files = {};
  files.elevation = SharedFile("dem/zion_srtm_4326.tif");
  files.materials = SharedFile("landcover/zion_nlcd2011.tif");
  files.material_table = "nlcd";
  const auto zion = LoadTerrain(files);
  EXPECT_LT(zion->materials().Share(MaterialMap::kNone), 0.05);

  files = {};
  files.elevation = SharedFile("dem/tahoe_lidar_bareearth.tif");
  files.materials = SharedFile("landcover/tahoe_highrez_training.shp");
  const std::string table = R"({"schema": "dbd.materials/1", "materials": [
      {"code": 1, "name": "tree", "cone_index_kpa": 900, "passable": false},
      {"code": 2, "name": "shrub", "cone_index_kpa": 1000},
      {"code": 3, "name": "non-vegetated", "cone_index_kpa": 1500}]})";
  TemporaryDirectory directory;
  files.material_table = directory.Write("table.json", table);
  const auto tahoe = LoadTerrain(files);
  EXPECT_GT(tahoe->materials().Share(0), 0);
  EXPECT_GT(tahoe->materials().Share(2), 0);
}

}  // namespace
}  // namespace dbd
