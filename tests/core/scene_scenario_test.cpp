#include <dbd/core/scene_scenario.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

std::shared_ptr<const VehicleModel> Car() { return LoadVehicle("tomcar-tm27"); }

TEST(ConvoyScenario, AllDriveTheWayAndStopWithoutBumping) {
  SerialExecutor serial;
  const SceneRecord record = RecordScene(MakeConvoyScenario(Car(), 3), serial);
  EXPECT_TRUE(record.arrived);
  EXPECT_EQ(record.bodies, 15);
  EXPECT_EQ(record.largest_bumper_force, 0);
  EXPECT_EQ(record.rows.size() % 3, 0u);
  const SceneRow& first = record.rows[record.rows.size() - 3];
  const SceneRow& last = record.rows.back();
  EXPECT_EQ(last.vehicle, 2);
  // The way ends at x = 120 m, for the rear axle; the centre of mass is 0.784 m ahead of it.
  EXPECT_NEAR(first.p_WB.x(), 120.8, 0.7);
  EXPECT_NEAR(last.gap, 3.0, 0.6);
  double widest = 0;
  for (const SceneRow& row : record.rows) widest = std::max(widest, row.p_WB.y());
  EXPECT_NEAR(widest, 2.5, 0.4);  // all wind with the way
}

TEST(ConvoyScenario, TooShortATimeGapBumps) {
  SceneScenarioOptions options;
  options.target_speed = 8;
  options.gap = {.standing_gap = 0.02, .time_gap = 0.05};
  SerialExecutor serial;
  const SceneRecord record = RecordScene(MakeConvoyScenario(Car(), 3, options), serial);
  EXPECT_GT(record.largest_bumper_force, 100);
}

TEST(RoadTrainScenario, DrivesTheWayCoupled) {
  SceneScenarioOptions options;
  options.target_speed = 4;
  SerialExecutor serial;
  const SceneRecord record = RecordScene(
      MakeRoadTrainScenario(LoadVehicle("tractor"), LoadTrailer("farm-trailer"), 2, options),
      serial);
  EXPECT_TRUE(record.arrived);
  EXPECT_EQ(record.bodies, 9);
  EXPECT_GT(record.largest_drawbar_force, 500);
  EXPECT_LT(record.largest_drawbar_stretch, 0.02);
}

TEST(SceneScenario, RefusesWhatMakesNoSense) {
  EXPECT_EQ(InputErrorOf([] { MakeConvoyScenario(Car(), 0); }),
            "convoy: needs at least one vehicle");
  SceneScenarioOptions still;
  still.target_speed = 0;
  EXPECT_EQ(InputErrorOf([&] { MakeConvoyScenario(Car(), 2, still); }),
            "convoy: target speed must be above 0");
  EXPECT_EQ(InputErrorOf([] { MakeRoadTrainScenario(Car(), LoadTrailer("farm-trailer"), -1); }),
            "road train: the number of trailers must not be negative");
  EXPECT_EQ(InputErrorOf([] { WriteSceneRows("/nonexistent/rows.csv", {}); }),
            "/nonexistent/rows.csv: cannot be written");
}

}  // namespace
}  // namespace dbd
