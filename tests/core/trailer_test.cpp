#include <dbd/core/trailer.h>

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// A tractor with two trailers that follows `path` at 3 m/s.
std::vector<SceneVehicle> Train(const Path& path) {
  SceneVehicle tractor;
  tractor.model = LoadVehicle("tractor");
  tractor.driver =
      std::make_shared<const Driver>(*tractor.model, path, DriverOptions{.target_speed = 3});
  return MakeRoadTrain(tractor, LoadTrailer("farm-trailer"), 2);
}

nlohmann::json TrailerJson() { return nlohmann::json::parse(BuiltInTrailerText("farm-trailer")); }

std::string MessageOf(const nlohmann::json& file) {
  return InputErrorOf([&] { ParseTrailer(file.dump(), "t.json"); });
}

TEST(RoadTrain, StandsWithoutForceInItsDrawbars) {
  const auto ground = MakePlaneGround(0, 0);
  const Scene scene(Train(Path({{-50, 0}, {50, 0}})), *ground);
  for (const int trailer : {1, 2}) EXPECT_LT(std::abs(scene.DrawbarForce(trailer)), 50) << trailer;
  // Design pose: the axle loads of 3,000 kg at 1.2 of 2.4 m are equal, so that it stands level.
  EXPECT_NEAR(scene.Chassis(1).pitch, 0, 2e-3);
  EXPECT_NEAR(scene.Chassis(1).p_WB.z(), 1.05, 5e-3);
}

TEST(RoadTrain, FollowsItsTractorRoundACurveAndStaysCoupled) {
  std::vector<Eigen::Vector2d> points;
  for (double x = -40; x < 0; x += 1) points.push_back({x, 0});
  for (double a = 0; a <= 2; a += 0.02) points.push_back({15 * std::sin(a), 15 - 15 * std::cos(a)});
  const auto ground = MakeRandomGround(0, 0.03, 0.5, 5);
  std::vector<SceneVehicle> train = Train(Path(points));
  for (SceneVehicle& vehicle : train) vehicle.position.x() -= 10;
  Scene scene(train, *ground);
  SerialExecutor serial;
  double stretch = 0, pull = 0, off_circle = 0;
  for (int i = 0; i < 140; ++i) {
    scene.Advance(0.1, serial);
    for (const int trailer : {1, 2}) {
      stretch = std::max(stretch, std::abs(scene.DrawbarStretch(trailer)));
      pull = std::max(pull, scene.DrawbarForce(trailer));
      const Eigen::Vector3d p = scene.Chassis(trailer).p_WB;
      if (p.x() > 10) {
        off_circle = std::max(off_circle, std::abs(std::hypot(p.x(), p.y() - 15) - 15));
      }
    }
  }
  EXPECT_TRUE(scene.IsSane());
  EXPECT_GT(scene.Chassis(2).p_WB.y(), 4.0);  // the last one is well in the curve
  EXPECT_GT(pull, 500);
  // Coupled: 1e6 N/m hold two trailers' starting and rolling resistance within 20 mm.
  EXPECT_LT(stretch, 0.02);
  EXPECT_GT(off_circle, 0);
  EXPECT_LT(off_circle, 1.5);  // trailers cut the corner a little
}

TEST(RoadTrain, TrailersBrakeWithTheirTractor) {
  const auto ground = MakePlaneGround(0, 0);
  Scene scene(Train(Path({{-50, 0}, {14, 0}})), *ground);
  SerialExecutor serial;
  scene.Advance(12, serial);
  EXPECT_TRUE(scene.Arrived(0));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(scene.Chassis(i).forward_speed, 0, 0.02) << i;
  EXPECT_LT(std::abs(scene.DrawbarStretch(1)), 0.02);
}

TEST(RoadTrain, PlacesTrailersBehindEachOtherOnAnyHeading) {
  SceneVehicle tractor;
  tractor.model = LoadVehicle("tractor");
  tractor.position = {3, 4};
  tractor.heading = std::numbers::pi / 2;
  const auto train = MakeRoadTrain(tractor, LoadTrailer("farm-trailer"), 2);
  ASSERT_EQ(train.size(), 3u);
  // Hitch 0.95 m behind the tractor's rear axle, bar 1.8 m, pivot 2.7 m ahead of the trailer's.
  EXPECT_NEAR(train[1].position.x(), 3, 1e-9);
  EXPECT_NEAR(train[1].position.y(), 4 - 0.95 - 1.8 - 2.7, 1e-9);
  // The trailer's own rear is 0.6 m behind its axle.
  EXPECT_NEAR(train[2].position.y(), train[1].position.y() - 0.6 - 1.8 - 2.7, 1e-9);
  EXPECT_EQ(train[2].ahead, 1);
}

TEST(TrailerFile, RefusesWhatMakesNoSense) {
  nlohmann::json file = TrailerJson();
  EXPECT_EQ(MessageOf(file), "");
  file["axles"][0]["driven"] = true;
  EXPECT_EQ(MessageOf(file), "t.json: axles: one is driven: a trailer has no powertrain");
  file = TrailerJson();
  file["axles"][1].erase("steer_ratio");
  file["axles"][1].erase("max_steer_deg");
  EXPECT_EQ(MessageOf(file), "t.json: axles: none steers");
  file = TrailerJson();
  file["drawbar"]["length"] = -1;
  EXPECT_NE(MessageOf(file).find("t.json: drawbar.length"), std::string::npos) << MessageOf(file);
  file = TrailerJson();
  file["powertrain"] = nlohmann::json::object();
  EXPECT_NE(MessageOf(file).find("powertrain"), std::string::npos) << MessageOf(file);
  EXPECT_EQ(InputErrorOf([] { LoadTrailer("boat"); }),
            "trailer \"boat\" is not known; built in: farm-trailer (a file needs '/' or .json in "
            "its name)");
}

TEST(TrailerFile, IsNoVehicleToDrive) {
  const std::string message = InputErrorOf([] { ParseVehicle(TrailerJson().dump(), "t.json"); });
  EXPECT_NE(message.find("schema"), std::string::npos) << message;
}

}  // namespace
}  // namespace dbd
