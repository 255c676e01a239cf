#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "support/core_drive.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

const auto kNothing = [](const Simulation&) {};

Simulation Placed(const Ground& ground, double heading = 0, double settle_time = 1) {
  Simulation simulation(Tm27(), ground);
  simulation.Place(Eigen::Vector2d::Zero(), heading, settle_time);
  return simulation;
}

TEST(Simulation, SettlesOnFlatGroundToTheStatics) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground, 0, 2);
  Stand(simulation, 1);
  const ChassisView chassis = simulation.Chassis();
  EXPECT_NEAR(chassis.p_WB.z(), 0.475, 0.002);  // 0.381 + 0.094
  EXPECT_NEAR(chassis.pitch, 0, Degrees(0.05));
  EXPECT_NEAR(chassis.roll, 0, Degrees(0.001));
  for (int i = 0; i < 4; ++i) {
    const double expected = i < 2 ? 2238.773 : 1439.977;
    EXPECT_NEAR(simulation.Wheel(i).load, expected, 0.005 * expected) << i;
    EXPECT_NEAR(simulation.SpringForce(i), i < 2 ? 3822.042 : 2848.872, 30) << i;
  }
}

TEST(Simulation, StandsForAMinuteWithoutDrifting) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground, 0.3, 3);
  const ChassisView before = simulation.Chassis();
  Stand(simulation, 60);
  const ChassisView after = simulation.Chassis();
  EXPECT_LT((after.p_WB - before.p_WB).head<2>().norm(), 1e-4);
  EXPECT_NEAR(after.p_WB.z(), before.p_WB.z(), 1e-3);
  EXPECT_NEAR(after.yaw, before.yaw, 1e-6);
  EXPECT_LT(after.v_WB.norm(), 1e-4);
}

TEST(Simulation, PlacesTheSteeringOriginOnTheGround) {
  const auto ground = MakePlaneGround(0.1, -0.05);
  Simulation simulation(Tm27(), *ground);
  simulation.Place({12, -7}, 1.2);
  const DriverView view = simulation.ViewForDriver();
  // The reference point stands 0.381 m above the ground along its normal, 0.04 m downhill.
  EXPECT_LT((view.position - Eigen::Vector2d(12, -7)).norm(), 0.07);
  EXPECT_NEAR(view.heading, 1.2, 0.01);
  EXPECT_EQ(simulation.time(), 0);
  EXPECT_EQ(simulation.drive_energy(), 0);
}

TEST(Simulation, DrivesAHundredMetresStraight) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  Driver driver(Tm27(), Path(), {.target_speed = 8});
  driver.SetStart({0, 0}, 0);
  double worst = 0;
  Follow(driver, simulation, 15, [&](const Simulation& s) {
    worst = std::max(worst, std::abs(s.ViewForDriver().position.y()));
  });
  EXPECT_GT(simulation.ViewForDriver().position.x(), 100);
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(simulation.Chassis().forward_speed, 8, 0.2);
  // Undriven wheels roll freely but for their carcass loss: towed slip -0.0062 on hard soil.
  EXPECT_NEAR(simulation.Wheel(2).slip, -0.0062, 0.001);
  EXPECT_NEAR(simulation.Wheel(3).slip, -0.0062, 0.001);
}

TEST(Simulation, DrivesStraightWithoutADriver) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 10) simulation.Advance({.engine_torque = 40});
  EXPECT_GT(simulation.Chassis().p_WB.x(), 60);
  EXPECT_LT(std::abs(simulation.Chassis().p_WB.y()), 0.01);
}

TEST(Simulation, HoldsACircle) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  std::vector<Eigen::Vector2d> points;
  for (double a = 0; a < 10; a += 0.02) {
    points.emplace_back(20 * std::sin(a), 20 * (1 - std::cos(a)));
  }
  const Driver driver(Tm27(), Path(points), {.target_speed = 5, .stop_at_end = false});
  double worst = 0, acceleration = 0, speed = 0, roll = 0;
  int count = 0;
  Follow(driver, simulation, 30, [&](const Simulation& s) {
    const Eigen::Vector2d d = s.ViewForDriver().position - Eigen::Vector2d(0, 20);
    worst = std::max(worst, std::abs(d.norm() - 20));
    if (s.time() < 15) return;
    const ChassisView chassis = s.Chassis();
    acceleration += chassis.v_WB.head<2>().norm() * chassis.w_WB.z();
    speed += chassis.forward_speed;
    roll += chassis.roll;
    ++count;
  });
  EXPECT_LT(worst, 0.05 * 20);
  EXPECT_NEAR(speed / count, 5, 0.1);
  EXPECT_NEAR(acceleration / count, 5.0 * 5.0 / 20, 0.07);  // v^2 / r
  EXPECT_GT(roll / count, Degrees(0.2));  // leans out of a left turn: left side up
}

TEST(Simulation, WheelLoadsOnASlopeCarryTheNormalForce) {
  const auto ground = MakePlaneGround(0, std::tan(Degrees(15)));
  Simulation simulation = Placed(*ground, 0, 3);
  Stand(simulation, 2);
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += simulation.Wheel(i).load;
  EXPECT_NEAR(sum, 750 * kGravity * std::cos(Degrees(15)), 40);
  EXPECT_GT(simulation.Wheel(1).load, simulation.Wheel(0).load);  // the ground rises to the left
  EXPECT_GT(simulation.Wheel(3).load, simulation.Wheel(2).load);
}

/// Sum of the tires' forces, and of their moments about the whole vehicle's centre of mass.
std::pair<Eigen::Vector3d, Eigen::Vector3d> GroundReaction(const Simulation& simulation) {
  const ChassisView chassis = simulation.Chassis();
  Eigen::Vector3d mass_moment = Tm27().bodies[0].mass * chassis.p_WB;
  for (int i = 0; i < 4; ++i) {
    mass_moment += Tm27().bodies[Tm27().wheels[i].body].mass * simulation.Wheel(i).p_WH;
  }
  const Eigen::Vector3d center = mass_moment / Tm27().total_mass();
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    const WheelView wheel = simulation.Wheel(i);
    const Eigen::Vector3d left = chassis.q_WB * Eigen::Vector3d::UnitY();
    const Eigen::Vector3d forward = left.cross(wheel.normal_W).normalized();
    const Eigen::Vector3d f = wheel.load * wheel.normal_W + wheel.net_traction * forward +
                              wheel.lateral * wheel.normal_W.cross(forward);
    force += f;
    moment += (wheel.contact_W - center).cross(f);
  }
  return {force, moment};
}

TEST(Simulation, StandingOnASlopeTheTiresBalanceTheWeight) {
  for (const auto& [grade_x, grade_y] : {std::pair(0.0, 0.268), {0.268, 0.0}, {0.1, -0.15}}) {
    const auto ground = MakePlaneGround(grade_x, grade_y);
    Simulation simulation = Placed(*ground, 0, 3);
    Stand(simulation, 6);
    const auto [force, moment] = GroundReaction(simulation);
    EXPECT_LT((force - Eigen::Vector3d(0, 0, 750 * kGravity)).norm(), 20) << grade_x;
    EXPECT_LT(moment.norm(), 30) << grade_x;  // of W h = 3282 N m
  }
}

TEST(Simulation, ReachesItsTopSpeed) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 40) simulation.Advance({.engine_torque = 1000});
  EXPECT_NEAR(simulation.Chassis().forward_speed, TopSpeed(Tm27()), 0.03 * TopSpeed(Tm27()));
  EXPECT_EQ(simulation.powertrain().gear, 4);
}

TEST(Simulation, BrakesToAStandWithoutReversing) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 5) simulation.Advance({.engine_torque = 60});
  const double before = simulation.Chassis().forward_speed;
  const double x = simulation.Chassis().p_WB.x();
  Stand(simulation, 6);
  EXPECT_LT(std::abs(simulation.Chassis().forward_speed), 0.02);  // the body still rocks
  // No shorter than with the tires' largest force, 0.88 g, and not ten times longer.
  const double distance = simulation.Chassis().p_WB.x() - x;
  EXPECT_GT(distance, before * before / (2 * (0.88 + 0.1) * kGravity));
  EXPECT_LT(distance, before * before / (2 * 0.3 * kGravity));
}

TEST(Simulation, DriveEnergyCoversTheWorkDone) {
  const auto ground = MakePlaneGround(std::tan(Degrees(8)), 0);
  Simulation simulation = Placed(*ground);
  while (simulation.time() < 8) simulation.Advance({.engine_torque = 70});
  const ChassisView chassis = simulation.Chassis();
  const double gained =
      750 * (kGravity * (chassis.p_WB.z() - 0.475) + 0.5 * chassis.v_WB.squaredNorm());
  EXPECT_GT(simulation.drive_energy(), gained);
  EXPECT_LT(simulation.drive_energy(), 2.5 * gained);
}

TEST(Simulation, HashSeesThePowertrain) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation braked = Placed(*ground), driven = Placed(*ground);
  EXPECT_EQ(braked.StateHash(), driven.StateHash());
  // Before the first step with torque nothing has moved yet, but the clutch knows.
  braked.Advance({.brake = 1});
  driven.Advance({.engine_torque = 1e-9, .brake = 1});
  EXPECT_NE(braked.StateHash(), driven.StateHash());
}

/// A TM27 whose belly hangs low enough to lie on the ground under the disc tire's rig.
TEST(Simulation, TheRigLaysBelliesOnTheGroundToo) {
  VehicleModel vehicle = Tm27();
  ContactModel skid;
  skid.p_B = {0, 0, -0.5};  // 25 mm below level ground
  skid.stiffness = 2e5;
  skid.damping = 4000;
  vehicle.contacts.push_back(skid);
  const auto ground = MakePlaneGround(0, 0);
  SimulationOptions options;
  options.tire = TireKind::kVerticalDisc;
  const auto height = [&](const VehicleModel& model) {
    Simulation simulation(model, *ground, options);
    simulation.Place(Eigen::Vector2d::Zero(), 0, 2);
    return simulation.Chassis().p_WB.z();
  };
  EXPECT_GT(height(vehicle), height(Tm27()) + 0.01);
}

TEST(Simulation, FallsAndReportsNoContactInTheAir) {
  const auto low = MakePlaneGround(0, 0);
  Simulation simulation(Tm27(), *low);
  simulation.Place(Eigen::Vector2d::Zero(), 0, 0);
  EXPECT_TRUE(simulation.IsSane());
  EXPECT_EQ(simulation.time(), 0);
  simulation.Advance({});
  EXPECT_DOUBLE_EQ(simulation.time(), simulation.control_step());
}

TEST(Simulation, BacksAsFarAsItDrives) {
  // Level, firm ground: 10 m ahead, back to where it began, and it stands there.
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation = Placed(*ground);
  const Path path({{0, 0}, {10, 0}, {0, 0}}, {false, false, true});
  Driver driver(Tm27(), path, {.target_speed = 4});
  double farthest = 0, slowest = 0, slip = 0;
  Follow(driver, simulation, 30, [&](const Simulation& s) {
    farthest = std::max(farthest, s.ViewForDriver().position.x());
    slowest = std::min(slowest, s.Chassis().forward_speed);
    if (s.Chassis().forward_speed < -0.5) slip = std::min(slip, s.Wheel(0).slip);
  });
  EXPECT_NEAR(farthest, 10, 0.2);
  EXPECT_NEAR(simulation.ViewForDriver().position.x(), 0, 0.2);
  EXPECT_NEAR(simulation.ViewForDriver().position.y(), 0, 0.01);
  EXPECT_NEAR(simulation.Chassis().forward_speed, 0, 0.05);
  EXPECT_NEAR(slowest, -kReverseSpeed, 0.3);
  EXPECT_LT(slip, -0.005);  // the sign of the force: the driven wheels push backwards
}

TEST(Simulation, BacksUpASlope) {
  // 15 degrees with the nose downhill: the reverse gear has the torque of the lowest gear.
  const auto ground = MakePlaneGround(-std::tan(Degrees(15)), 0);
  Simulation simulation = Placed(*ground);
  const Path path({{0, 0}, {-15, 0}}, {false, true});
  Driver driver(Tm27(), path, {});
  Follow(driver, simulation, 20, kNothing);
  EXPECT_NEAR(simulation.ViewForDriver().position.x(), -15, 0.3);
  EXPECT_GT(simulation.drive_energy(), Tm27().total_mass() * 9.81 * 15 * std::tan(Degrees(15)));
}

}  // namespace
}  // namespace dbd
