#include "plan_files.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/synthetic_plan.h"
#include "support/temporary_directory.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A vector file read back with OGR.
class Layer {
 public:
  explicit Layer(const std::string& file, const char* name = nullptr) {
    GDALAllRegister();
    dataset_.reset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    if (dataset_) layer_ = name ? dataset_->GetLayerByName(name) : dataset_->GetLayer(0);
  }
  OGRLayer* operator->() const { return layer_; }
  explicit operator bool() const { return layer_ != nullptr; }

 private:
  GDALDatasetUniquePtr dataset_;
  OGRLayer* layer_ = nullptr;
};

json ReadJson(const std::string& file) {
  std::ifstream stream(file);
  return json::parse(stream);
}

void Write(const SyntheticPlan& made, const std::string& directory) {
  OutputDirectory output(directory);
  WritePlanFiles(made.record(), &output);
}

std::vector<std::string> NamesIn(const std::string& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(PlanFiles, ARouteHasAllFiles) {
  const TemporaryDirectory scratch;
  Write(MakePlan(kUtm33), scratch.File("out"));
  EXPECT_THAT(NamesIn(scratch.File("out")),
              testing::UnorderedElementsAre("plan.json", "map.png", "report.html",
                                            "candidates.geojson", "trace.csv", "route.geojson",
                                            "route.gpx", "route.kml", "route.gpkg"));
}

TEST(PlanFiles, ANoGoHasNoRouteFiles) {
  const TemporaryDirectory scratch;
  Write(MakeNoGoPlan(kUtm33), scratch.File("out"));
  EXPECT_THAT(
      NamesIn(scratch.File("out")),
      testing::UnorderedElementsAre("plan.json", "map.png", "report.html", "candidates.geojson"));
  const json plan = ReadJson(scratch.File("out/plan.json"));
  EXPECT_EQ(plan["status"], "no_go");
  EXPECT_EQ(plan["route"], nullptr);
  EXPECT_EQ(plan["certificate"], nullptr);
  EXPECT_EQ(plan["blocked_at"]["map"], json::array({500100.0, 5000060.0}));
}

TEST(PlanFiles, WithoutCoordinateSystemTheRouteIsCsv) {
  const TemporaryDirectory scratch;
  Write(MakePlan(""), scratch.File("out"));
  EXPECT_THAT(NamesIn(scratch.File("out")),
              testing::UnorderedElementsAre("plan.json", "map.png", "report.html", "trace.csv",
                                            "route.csv"));
}

TEST(PlanFiles, RouteGeoJsonIsALineAtTheRightPlaceOnEarth) {
  const TemporaryDirectory scratch;
  const SyntheticPlan made = MakePlan(kUtm33);
  Write(made, scratch.File("out"));
  const Layer layer(scratch.File("out/route.geojson"));
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->GetFeatureCount(), 1);
  const OGRFeatureUniquePtr feature(layer->GetNextFeature());
  const auto* line = dynamic_cast<const OGRLineString*>(feature->GetGeometryRef());
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->getNumPoints(), 641);  // every 0.25 m of 160 m
  const Eigen::Vector2d start = made.terrain.frame().ToWgs84({20, 50});
  EXPECT_NEAR(line->getX(0), start.x(), 1e-8);
  EXPECT_NEAR(line->getY(0), start.y(), 1e-8);
  EXPECT_NEAR(line->getZ(0), 102, 1e-9);  // the ground, 100 + 0.1 * 20
  EXPECT_STREQ(feature->GetFieldAsString("outcome"), "reached");
  EXPECT_DOUBLE_EQ(feature->GetFieldAsDouble("length_m"), 160);
}

TEST(PlanFiles, GpxIsATrackWithHeights) {
  const TemporaryDirectory scratch;
  Write(MakePlan(kUtm33), scratch.File("out"));
  const Layer points(scratch.File("out/route.gpx"), "track_points");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->GetFeatureCount(), 641);
  const OGRFeatureUniquePtr first(points->GetNextFeature());
  EXPECT_NEAR(first->GetFieldAsDouble("ele"), 102, 1e-6);
  EXPECT_NEAR(first->GetGeometryRef()->toPoint()->getX(), 15.000254, 1e-5);
}

TEST(PlanFiles, CandidatesHaveLinesAndThePlacesWhereTheyEnded) {
  const TemporaryDirectory scratch;
  Write(MakePlan(kUtm33), scratch.File("out"));
  const json features = ReadJson(scratch.File("out/candidates.geojson"))["features"];
  ASSERT_EQ(features.size(), 3);  // two lines and the end of candidate 1
  EXPECT_EQ(features[0]["properties"]["chosen"], true);
  EXPECT_EQ(features[0]["properties"]["score"], 42.5);
  EXPECT_EQ(features[1]["properties"]["outcome"], "immobilized");
  EXPECT_EQ(features[1]["properties"]["score"], nullptr);
  EXPECT_EQ(features[2]["geometry"]["type"], "Point");
}

TEST(PlanJson, HoldsTheAnswerAndItsProof) {
  const json plan = json::parse(PlanJson(MakePlan(kUtm33).record()));
  EXPECT_EQ(plan["schema"], "dbd.plan/1");
  EXPECT_EQ(plan["status"], "route");
  EXPECT_EQ(plan["digest"], "00abcdef01234567");
  EXPECT_EQ(plan["route"]["candidate"], 0);
  EXPECT_EQ(plan["route"]["mean_speed"], 5);  // 160 m in 32 s
  EXPECT_EQ(plan["request"]["start"]["heading_deg"], 90);
  EXPECT_EQ(plan["certificate"]["binding"], "clearance");
  EXPECT_EQ(plan["certificate"]["margins"][0]["unit"], "deg");
  EXPECT_NEAR(plan["certificate"]["margins"][0]["limit"].get<double>(), 28.6479, 1e-4);  // 0.5 rad
  EXPECT_EQ(plan["certificate"]["per_meter"]["distance_m"].size(), 161);
  EXPECT_EQ(plan["candidates"][1]["reason"], "wheels spin");
  EXPECT_EQ(plan["candidates"][0]["score"]["terms"]["energy"], 7.2);
  EXPECT_EQ(plan["timing_s"]["rollouts"], 0.25);
  for (const char* library : {"dbd", "gdal", "proj", "ompl", "octomap", "tbb"}) {
    EXPECT_THAT(plan["versions"][library].get<std::string>(), testing::MatchesRegex("[0-9]+\\..*"));
  }
}

TEST(PlanJson, FileNamesThatAreNotUtf8DoNotMatter) {
  SyntheticPlan made = MakePlan("");
  made.arguments.terrain.dem = {"h\xfcgel.tif"};
  EXPECT_NO_THROW(json::parse(PlanJson(made.record())));
}

}  // namespace
}  // namespace dbd
