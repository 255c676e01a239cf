#include "route_formats.h"

#include <dbd/terrain/geo_path.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <optional>

#include "geojson.h"
#include "support/temporary_directory.h"
#include "support/terrain_files.h"
#include "synthetic_plan.h"
#include "text.h"

namespace dbd {
namespace {

class RouteFormats : public testing::Test {
 protected:
  RouteFormats() : plan_(MakePlan(kUtm33)), route_(plan_.plan.rollouts[0]) {
    for (TraceSample& sample : route_.trace) sample.y += std::sin(sample.s);
  }

  std::string File(const char* name) { return scratch_.File(name); }

  TemporaryDirectory scratch_;
  SyntheticPlan plan_;
  Rollout route_;
};

struct Place {
  const char* name;
  std::string crs;
  Eigen::Vector2d corner;  // of the ground, in `crs`
  double cell;             // in its unit
};

// 160 m of route on ground in this system: its frame is what the loader makes of it.
class RouteReadBack : public RouteFormats, public testing::WithParamInterface<Place> {
 protected:
  RouteReadBack() {
    const Place& place = GetParam();
    TestRaster raster;
    raster.columns = raster.rows = 8;
    raster.crs = place.crs;
    raster.transform = {place.corner.x(), place.cell, 0, place.corner.y(), 0, -place.cell};
    frame_ = LoadElevationOnly(raster.Write(File("dem.tif")))->frame();
  }

  // Largest distance of what was written from what is read back, point by point [m].
  double WorstAfter(const std::string& file) {
    const GeoPath path = ReadGeoPath(file);
    EXPECT_EQ(path.points.size(), route_.trace.size());
    double worst = path.points.size() == route_.trace.size() ? 0 : 1e9;
    for (std::size_t i = 0; i < std::min(path.points.size(), route_.trace.size()); ++i) {
      const Eigen::Vector2d local = frame_->FromWgs84(path.points[i]);
      const Eigen::Vector2d written(route_.trace[i].x, route_.trace[i].y);
      worst = std::max(worst, (local - written).norm());
    }
    return worst;
  }

  std::optional<LocalFrame> frame_;
};

TEST_P(RouteReadBack, LandsWithinACentimetre) {
  WriteGpx(File("a.gpx"), route_, "drive", *frame_);
  WriteKml(File("a.kml"), route_, "drive", *frame_);
  WriteGeoPackage(File("a.gpkg"), route_, "drive", *frame_);
  WriteTextFile(File("a.geojson"), RouteGeoJson(route_, "drive", *frame_));
  for (const char* name : {"a.gpx", "a.kml", "a.gpkg", "a.geojson"}) {
    const double worst = WorstAfter(File(name));
    EXPECT_LT(worst, 0.01) << name;
    RecordProperty(std::string(name).substr(2) + "_worst_mm", Format("%.4f", 1e3 * worst));
  }
}

// The route at 180 degrees lies on both sides of the date line.
INSTANTIATE_TEST_SUITE_P(Places, RouteReadBack,
                         testing::Values(Place{"Utm", "EPSG:32633", {500000, 5000000}, 1},
                                         Place{"Degrees", "EPSG:4326", {-119.93, 39.29}, 1e-5},
                                         Place{"NationalGrid", "EPSG:3794", {564000, 146000}, 1},
                                         Place{"Feet", "EPSG:2227", {6000000, 2000000}, 3},
                                         Place{"South", "EPSG:32719", {400000, 6300000}, 1},
                                         Place{"Svalbard", "EPSG:32633", {512000, 8700000}, 1},
                                         Place{"DegreesAtLatitude84", "EPSG:4326", {25, 84}, 1e-4},
                                         Place{"AntarcticIce", "EPSG:3031", {100000, -1200000}, 1},
                                         Place{"DateLine", "EPSG:32760", {819390, 8118000}, 1}),
                         [](const testing::TestParamInfo<Place>& place) {
                           return std::string(place.param.name);
                         });

TEST_F(RouteFormats, GiveHeightsAndTimes) {
  const LocalFrame& frame = plan_.terrain.frame();
  WriteGpx(File("a.gpx"), route_, "drive", frame);
  WriteGeoPackage(File("a.gpkg"), route_, "drive", frame);
  for (const auto& [name, layer_name] :
       {std::pair{"a.gpx", "track_points"}, {"a.gpkg", "points"}}) {
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(File(name).c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(dataset) << name;
    OGRLayer* layer = dataset->GetLayerByName(layer_name);
    ASSERT_TRUE(layer) << name;
    layer->SetNextByIndex(4);
    const OGRFeatureUniquePtr feature(layer->GetNextFeature());
    ASSERT_TRUE(feature) << name;
    const TraceSample& sample = route_.trace[4];
    int year, month, day, hour, minute, zone;
    float second;
    feature->GetFieldAsDateTime(feature->GetFieldIndex("time"), &year, &month, &day, &hour, &minute,
                                &second, &zone);
    EXPECT_EQ(year, 2000);
    EXPECT_NEAR(60.0 * minute + double{second}, sample.t, 0.01) << name;
    const int ele = feature->GetFieldIndex("ele");
    const double height =
        ele >= 0 ? feature->GetFieldAsDouble(ele) : feature->GetGeometryRef()->toPoint()->getZ();
    EXPECT_NEAR(height, sample.ground_z, 0.002) << name;
  }
}

}  // namespace
}  // namespace dbd
