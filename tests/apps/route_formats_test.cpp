#include "route_formats.h"

#include <dbd/terrain/geo_path.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "geojson.h"
#include "support/temporary_directory.h"
#include "synthetic_plan.h"
#include "text.h"

namespace dbd {
namespace {

class RouteFormats : public testing::Test {
 protected:
  RouteFormats() : plan_(MakePlan(kUtm33)), route_(plan_.plan.rollouts[0]) {
    for (TraceSample& sample : route_.trace) sample.y += std::sin(sample.s);
  }

  // Largest distance of what was written from what is read back, point by point [m].
  double WorstAfter(const std::string& file) {
    const GeoPath path = ReadGeoPath(file);
    EXPECT_EQ(path.points.size(), route_.trace.size());
    double worst = path.points.size() == route_.trace.size() ? 0 : 1e9;
    for (std::size_t i = 0; i < std::min(path.points.size(), route_.trace.size()); ++i) {
      const Eigen::Vector2d local = plan_.terrain.frame().FromWgs84(path.points[i]);
      const Eigen::Vector2d written(route_.trace[i].x, route_.trace[i].y);
      worst = std::max(worst, (local - written).norm());
    }
    return worst;
  }

  std::string File(const char* name) { return scratch_.File(name); }

  TemporaryDirectory scratch_;
  SyntheticPlan plan_;
  Rollout route_;
};

TEST_F(RouteFormats, LandWithinACentimetreWhenReadBack) {
  const LocalFrame& frame = plan_.terrain.frame();
  WriteGpx(File("a.gpx"), route_, "drive", frame);
  WriteKml(File("a.kml"), route_, "drive", frame);
  WriteGeoPackage(File("a.gpkg"), route_, "drive", frame);
  WriteTextFile(File("a.geojson"), RouteGeoJson(route_, "drive", frame));
  for (const char* name : {"a.gpx", "a.kml", "a.gpkg", "a.geojson"}) {
    EXPECT_LT(WorstAfter(File(name)), 0.01) << name;
  }
}

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
