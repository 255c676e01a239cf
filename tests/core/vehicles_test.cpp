#include <dbd/core/mobility.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_report.h>

#include <gtest/gtest.h>

#include <algorithm>
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

/// The rev limit in the highest gear; what motion resistance costs is far below full power.
TEST_P(Vehicles, TopSpeedOfTheGearing) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 60) simulation.Advance({.engine_torque = kFullThrottle});
  const PowertrainModel& p = vehicle_->powertrain;
  const double ratio = p.gear_ratios.back() * p.transfer_ratio * p.final_ratio;
  const double hand = p.max_speed / ratio * DrivenRadius();
  RecordProperty("speed", std::to_string(simulation.Chassis().forward_speed));
  RecordProperty("hand_speed", std::to_string(hand));
  EXPECT_NEAR(simulation.Chassis().forward_speed, hand, 0.03 * hand);
  EXPECT_NEAR(TopSpeed(*vehicle_), hand, 1e-9);
}

/// Drives on a plane, stops, comes to rest, and stands there for 30 s: how far it creeps [m].
double CreepAfterStopping(const VehicleModel& vehicle, const Ground& ground) {
  Simulation simulation(vehicle, ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0, 2);
  Driver driver(vehicle, Path(), {.target_speed = 1.5});
  driver.SetStart({0, 0}, 0);
  Follow(driver, simulation, 4, [](const Simulation&) {});
  EXPECT_GT(simulation.Chassis().forward_speed, 0.1);
  Stand(simulation, 20);  // until the lightly damped body has come to rest
  const ChassisView before = simulation.Chassis();
  Stand(simulation, 30);
  const ChassisView after = simulation.Chassis();
  EXPECT_LT(after.v_WB.norm(), 1e-4);
  return (after.p_WB - before.p_WB).norm();
}

/// A good part of what the vehicle is allowed, and no less than 15 deg.
double SlopeToStandOn(double limit) { return std::max(Degrees(15), 0.6 * limit); }

TEST_P(Vehicles, StopsAndHoldsUphillWithoutCreep) {
  const auto ground = MakePlaneGround(std::tan(SlopeToStandOn(vehicle_->limits.max_slope)), 0);
  EXPECT_LT(CreepAfterStopping(*vehicle_, *ground), 1e-4);
}

TEST_P(Vehicles, StopsAndHoldsDownhillWithoutCreep) {
  const auto ground = MakePlaneGround(-std::tan(SlopeToStandOn(vehicle_->limits.max_slope)), 0);
  EXPECT_LT(CreepAfterStopping(*vehicle_, *ground), 1e-4);
}

TEST_P(Vehicles, StopsAndHoldsOnASideSlopeWithoutCreep) {
  const auto ground = MakePlaneGround(0, std::tan(SlopeToStandOn(vehicle_->limits.max_roll)));
  EXPECT_LT(CreepAfterStopping(*vehicle_, *ground), 1e-4);
}

struct TiltLimit {
  double tilt = 0;  ///< between the last side slope on which it stood and the next [rad]
  double hand = 0;  ///< static limit there of the leaning vehicle [rad]
};

/// atan(offset / height) of the centre of mass against the lower wheels' contacts: the static limit
/// with springs and tires as far compressed as they are.
double LeaningLimit(const VehicleModel& vehicle, const Simulation& simulation, double tilt) {
  std::vector<int> wheels_on(vehicle.bodies.size());
  for (const WheelModel& wheel : vehicle.wheels) ++wheels_on[wheel.body];
  Eigen::Vector3d center = vehicle.bodies[0].mass * simulation.Chassis().p_WB;
  Eigen::Vector3d contact = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const WheelView view = simulation.Wheel(static_cast<int>(i));
    const int body = vehicle.wheels[i].body;
    center += vehicle.bodies[body].mass / wheels_on[body] * view.p_WH;
  }
  center /= vehicle.total_mass();
  for (const AxleModel& axle : vehicle.axles) contact += simulation.Wheel(axle.right).contact_W;
  const Eigen::Vector3d lever = contact / static_cast<double>(vehicle.axles.size()) - center;
  const Eigen::Vector3d down(0, -std::cos(tilt), -std::sin(tilt));
  const Eigen::Vector3d up(0, -std::sin(tilt), std::cos(tilt));
  return std::atan2(lever.dot(down), -lever.dot(up));
}

/// A tilt table: ground so grippy that the vehicle tips before it slides.
TiltLimit FindTiltLimit(VehicleModel vehicle) {
  for (WheelModel& wheel : vehicle.wheels) {
    wheel.tire.lateral_limit = 2;
    wheel.tire.traction.traction_max = 2;
  }
  TiltLimit limit;
  const double first = std::floor(0.75 * ToDegrees(StaticStabilityAngle(vehicle)));
  for (double degrees = first; degrees < 65; degrees += 0.5) {
    const double tilt = Degrees(degrees);
    const auto ground =
        MakePlaneGround(0, std::tan(tilt), {.cone_index = 5e6, .friction_limit = 2});
    Simulation simulation(vehicle, *ground);
    simulation.Place(Eigen::Vector2d::Zero(), 0, 4);
    const double hand = LeaningLimit(vehicle, simulation, tilt);
    Stand(simulation, 8);  // tipping starts slowly
    if (!simulation.IsSane() || std::abs(simulation.Chassis().roll) > tilt + Degrees(20)) break;
    limit = {tilt + Degrees(0.25), hand};  // half-way to the next, where it may tip
  }
  return limit;
}

TEST_P(Vehicles, TiltTable) {
  const TiltLimit limit = FindTiltLimit(*vehicle_);
  RecordProperty("tilt_deg", std::to_string(ToDegrees(limit.tilt)));
  RecordProperty("hand_deg", std::to_string(ToDegrees(limit.hand)));
  RecordProperty("rigid_deg", std::to_string(ToDegrees(StaticStabilityAngle(*vehicle_))));
  EXPECT_LT(limit.tilt, StaticStabilityAngle(*vehicle_));
  if (GetParam() == "tractor") {
    // A triangle of support: the springless tractor hardly leans, and the rigid limit holds.
    EXPECT_NEAR(limit.tilt, StaticStabilityAngle(*vehicle_), 0.05 * limit.tilt);
    return;
  }
  EXPECT_NEAR(limit.tilt, limit.hand, 0.05 * limit.hand);
}

/// A vehicle and a scenario.
class VehicleInScenario : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(VehicleInScenario, DrivesThrough) {
  const auto& [vehicle_name, scenario_name] = GetParam();
  const auto vehicle = LoadVehicle(vehicle_name);
  const Scenario scenario = MakeScenario(scenario_name);
  Simulation simulation = StartScenario(scenario, *vehicle);
  ScenarioDriver driver(scenario, *vehicle);
  while (simulation.time() < scenario.duration) {
    driver.Advance(simulation);
    ASSERT_TRUE(simulation.IsSane()) << "at " << simulation.time();
  }
  const ChassisView chassis = simulation.Chassis();
  RecordProperty("distance", std::to_string(chassis.p_WB.x()));
  RecordProperty("speed", std::to_string(chassis.forward_speed));
  const double speed = std::min(scenario.target_speed, TopSpeed(*vehicle));
  EXPECT_GT(chassis.p_WB.x(), 0.8 * speed * (scenario.duration - scenario.standing_time));
  EXPECT_LT(std::abs(chassis.p_WB.y()), 0.5);
  EXPECT_LT(std::abs(chassis.roll), Degrees(30));
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, VehicleInScenario,
                         ::testing::Combine(::testing::ValuesIn(BuiltInVehicleNames()),
                                            ::testing::ValuesIn(ScenarioNames())),
                         [](const auto& test) {
                           return Underscored(std::get<0>(test.param)) + "_" +
                                  std::get<1>(test.param);
                         });

INSTANTIATE_TEST_SUITE_P(BuiltIn, Vehicles, ::testing::ValuesIn(BuiltInVehicleNames()),
                         [](const auto& test) { return Underscored(test.param); });

}  // namespace
}  // namespace dbd
