#include <dbd/core/mobility.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_report.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/core_drive.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

// Every built-in vehicle: what must hold for each of them, from its own numbers.

constexpr double kFullThrottle = 1e5;  // [N m] more than any engine gives

class Vehicles : public ::testing::TestWithParam<std::string> {
 protected:
  std::shared_ptr<const VehicleModel> vehicle_ = LoadVehicle(GetParam());

  Simulation Placed(const Ground& ground, double settle_time = 2) const {
    Simulation simulation(*vehicle_, ground);
    simulation.Place(Eigen::Vector2d::Zero(), 0, settle_time);
    return simulation;
  }

  double DrivenRadius() const {
    double radius = 0;
    for (const WheelModel& wheel : vehicle_->wheels) {
      if (!vehicle_->axles[static_cast<std::size_t>(wheel.axle)].driven) continue;
      radius = LoadedRollingRadius(wheel.tire.radius, wheel.static_load / wheel.tire.stiffness);
    }
    return radius;
  }
};

TEST_P(Vehicles, SettlesInItsDesignPose) {
  const VehicleReport report = CheckVehicle(*vehicle_);
  EXPECT_LT(std::abs(report.settled_height_error), 2e-3);
  EXPECT_LT(std::abs(report.settled_pitch), Degrees(0.2));
  for (std::size_t i = 0; i < vehicle_->wheels.size(); ++i) {
    const double load = vehicle_->wheels[i].static_load;
    EXPECT_NEAR(report.wheel_loads[i], load, 0.02 * load) << vehicle_->wheels[i].name;
  }
  EXPECT_LT(vehicle_->steps.construction, 0.5 * report.fastest_mode_limit);
}

TEST_P(Vehicles, DrivesAllScenarios) {
  for (const std::string& name : ScenarioNames()) {
    const Scenario scenario = MakeScenario(name);
    Simulation simulation = StartScenario(scenario, *vehicle_);
    ScenarioDriver driver(scenario, *vehicle_);
    while (simulation.time() < scenario.duration) {
      driver.Advance(simulation);
      ASSERT_TRUE(simulation.IsSane()) << name << " at " << simulation.time();
    }
    const ChassisView chassis = simulation.Chassis();
    EXPECT_GT(chassis.p_WB.x(), name == "A" ? 20 : 5) << name;
    EXPECT_LT(std::abs(chassis.p_WB.y()), 0.5) << name;
    EXPECT_LT(std::abs(chassis.roll), Degrees(30)) << name;
  }
}

/// The rev limit in the highest gear; what motion resistance costs is far below full power.
TEST_P(Vehicles, TopSpeedOfTheGearing) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 60) simulation.Advance({.engine_torque = kFullThrottle});
  const PowertrainModel& p = vehicle_->powertrain;
  const double ratio = p.gear_ratios.back() * p.transfer_ratio * p.final_ratio;
  const double hand = p.max_speed / ratio * DrivenRadius();
  EXPECT_NEAR(simulation.Chassis().forward_speed, hand, 0.03 * hand);
  EXPECT_NEAR(TopSpeed(*vehicle_), hand, 1e-9);
}

TEST_P(Vehicles, StopsAndHoldsOnASlopeWithoutCreep) {
  const double grade = std::tan(0.6 * vehicle_->limits.max_slope);
  const auto ground = MakePlaneGround(grade, 0);
  Simulation simulation = Placed(*ground);
  Driver driver(*vehicle_, Path(), {.target_speed = 1.5});
  driver.SetStart({0, 0}, 0);
  Follow(driver, simulation, 4, [](const Simulation&) {});
  Stand(simulation, 5);
  const ChassisView before = simulation.Chassis();
  Stand(simulation, 20);
  const ChassisView after = simulation.Chassis();
  EXPECT_LT((after.p_WB - before.p_WB).norm(), 2e-3);
  EXPECT_LT(after.v_WB.norm(), 1e-3);
}

/// Steepest side slope on which the vehicle stands: the static angle, less what the springs and
/// tires give way, found with the vehicle held by its tires' side forces on grippy ground.
double TiltAngle(const VehicleModel& original) {
  VehicleModel vehicle = original;
  for (WheelModel& wheel : vehicle.wheels) {
    wheel.tire.lateral_limit = 2;  // it must tip, not slide
    wheel.tire.traction.traction_max = 2;
  }
  double steepest = 0;
  for (double tilt = 20; tilt < 60; tilt += 0.5) {
    const auto ground =
        MakePlaneGround(0, std::tan(Degrees(tilt)), {.cone_index = 5e6, .friction_limit = 2});
    Simulation simulation(vehicle, *ground);
    simulation.Place(Eigen::Vector2d::Zero(), 0, 4);
    Stand(simulation, 2);
    if (!simulation.IsSane() || std::abs(simulation.Chassis().roll) > Degrees(tilt + 20)) break;
    steepest = Degrees(tilt);
  }
  return steepest;
}

TEST_P(Vehicles, TiltTableAngle) {
  const double rigid = StaticStabilityAngle(*vehicle_);
  const double tilt = TiltAngle(*vehicle_);
  RecordProperty("rigid_deg", std::to_string(ToDegrees(rigid)));
  RecordProperty("tilt_deg", std::to_string(ToDegrees(tilt)));
  printf("%s rigid %.2f tilt %.2f\n", GetParam().c_str(), ToDegrees(rigid), ToDegrees(tilt));
  EXPECT_LT(tilt, 1.02 * rigid);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Vehicles, ::testing::ValuesIn(BuiltInVehicleNames()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace dbd
