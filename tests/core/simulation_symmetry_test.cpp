// Symmetries that the equations of motion have and the program must keep.
#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/core_ground.h"
#include "support/core_moved_ground.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

struct Track {
  std::vector<ChassisView> chassis;
  std::vector<double> left_load, right_load;
};

/// Pulls away, steers left and right, brakes.
DriverCommand Manoeuvre(double time, double side) {
  if (time < 1.5) return {.steer = 0.2 * side, .engine_torque = 60};
  if (time < 2.5) return {.steer = -0.1 * side, .engine_torque = 30};
  return {.steer = 0.05 * side, .brake = 0.5};
}

Track Drive(const Ground& ground, double heading, double side, double duration = 3) {
  Simulation simulation(Tm27(), ground);
  simulation.Place(Eigen::Vector2d::Zero(), heading);
  Track track;
  while (simulation.time() < duration) {
    simulation.Advance(Manoeuvre(simulation.time(), side));
    track.chassis.push_back(simulation.Chassis());
    track.left_load.push_back(simulation.Wheel(2).load);
    track.right_load.push_back(simulation.Wheel(3).load);
  }
  return track;
}

TEST(Symmetry, MirroredGroundAndSteeringMirrorTheDrive) {
  const auto wavy = [](double x, double y) {
    return 0.06 * std::sin(1.1 * x + 0.7 * y) * std::cos(0.4 * y);
  };
  const FunctionGround ground(wavy);
  const FunctionGround mirrored([&](double x, double y) { return wavy(x, -y); });
  const Track a = Drive(ground, 0, 1), b = Drive(mirrored, 0, -1);
  EXPECT_GT(a.chassis.back().p_WB.x(), 3);
  for (std::size_t i = 0; i < a.chassis.size(); ++i) {
    const Eigen::Vector3d p = b.chassis[i].p_WB;
    ASSERT_LT((a.chassis[i].p_WB - Eigen::Vector3d(p.x(), -p.y(), p.z())).norm(), 1e-9) << i;
    ASSERT_NEAR(a.chassis[i].yaw, -b.chassis[i].yaw, 1e-9) << i;
    ASSERT_NEAR(a.chassis[i].roll, -b.chassis[i].roll, 1e-9) << i;
    ASSERT_NEAR(a.chassis[i].pitch, b.chassis[i].pitch, 1e-9) << i;
    ASSERT_NEAR(a.left_load[i], b.right_load[i], 1e-4) << i;
  }
}

TEST(Symmetry, HeadingDoesNotMatterOnFlatGround) {
  const auto ground = MakePlaneGround(0, 0);
  const Track east = Drive(*ground, 0, 1);
  for (const double heading : {std::numbers::pi / 2, -2.1}) {
    const Track turned = Drive(*ground, heading, 1);
    const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
    for (std::size_t i = 0; i < east.chassis.size(); ++i) {
      ASSERT_LT((turned.chassis[i].p_WB - turn * east.chassis[i].p_WB).norm(), 1e-9) << i;
      ASSERT_NEAR(turned.chassis[i].pitch, east.chassis[i].pitch, 1e-9) << i;
    }
  }
}

TEST(Symmetry, GroundMovedAlongMovesTheDrive) {
  // The same bump 1 km farther on; positions that large cost about 1e-13 m of resolution.
  const auto near_bump = MakeBumpGround(5, 0.1);
  const FunctionGround far_bump([&](double x, double y) { return near_bump->Height(x - 1024, y); });
  const auto final_state = [](const Ground& ground, double x) {
    Simulation simulation(Tm27(), ground);
    simulation.Place({x, 0}, 0);
    while (simulation.time() < 3) simulation.Advance({.engine_torque = 50});
    ChassisView view = simulation.Chassis();
    view.p_WB.x() -= x;
    return view;
  };
  const ChassisView here = final_state(*near_bump, 0), there = final_state(far_bump, 1024);
  EXPECT_GT(here.p_WB.x(), 6);
  EXPECT_LT((here.p_WB - there.p_WB).norm(), 1e-6);
  EXPECT_NEAR(here.pitch, there.pitch, 1e-6);
}

/// Largest distance between a drive and the same drive on the ground turned and moved away.
double CostOfMoving(const VehicleModel& vehicle, const Scenario& scenario, double duration) {
  constexpr double kYaw = 2.2;
  const MovedGround moved(*scenario.ground, kYaw, {1000, -700, 250});
  Simulation here(vehicle, *scenario.ground), there(vehicle, moved);
  here.Place(Eigen::Vector2d::Zero(), 0);
  there.Place(moved.Moved(Eigen::Vector2d::Zero().eval()), kYaw);
  const double torque = 0.8 * FullThrottleTorque(vehicle.powertrain, vehicle.powertrain.min_speed);
  double worst = 0;
  while (here.time() < duration) {
    const double steer = 0.02 * std::sin(here.time());
    const DriverCommand command{.steer = steer, .engine_torque = torque};
    here.Advance(command);
    there.Advance(command);
    worst = std::max(worst, (moved.Moved(here.Chassis().p_WB) - there.Chassis().p_WB).norm());
  }
  EXPECT_GT(here.Chassis().p_WB.x(), 4.5) << scenario.name;
  return worst;
}

TEST(Symmetry, OriginAndHeadingOfTheWorldDoNotMatter) {
  for (const std::string& name : ScenarioNames()) {
    for (const char* vehicle : {"tomcar-tm27", "utility-4x4"}) {
      EXPECT_LT(CostOfMoving(*LoadVehicle(vehicle), MakeScenario(name), 5), 1e-6)
          << vehicle << " in " << name;
    }
  }
}

TEST(Symmetry, BelliesAndBumpersSeeTheGroundTheSameWayRound) {
  // A crest that the utility vehicle's belly lies on, oblique to the world's axes.
  const FunctionGround crest([](double x, double y) {
    return 0.6 * std::exp(-0.8 * std::pow(x - 5 - 0.2 * y, 2)) + 0.05 * std::sin(2 * x + y);
  });
  const auto vehicle = LoadVehicle("utility-4x4");
  const Scenario scenario{"crest", "", 0, 0, 0, 0, std::make_shared<FunctionGround>(crest)};
  EXPECT_LT(CostOfMoving(*vehicle, scenario, 5), 1e-6);
}

TEST(Symmetry, TwoRunsAreBitIdentical) {
  const auto ground = MakeRandomGround(1, 0.1, 0.5, 5);
  const auto hashes = [&] {
    Simulation simulation(Tm27(), *ground);
    simulation.Place(Eigen::Vector2d::Zero(), 0.1);
    std::vector<std::uint64_t> result;
    while (simulation.time() < 3) {
      simulation.Advance(Manoeuvre(simulation.time(), 1));
      result.push_back(simulation.StateHash());
    }
    return result;
  };
  const auto first = hashes(), second = hashes();
  EXPECT_EQ(first, second);
  EXPECT_NE(first[10], first[11]);
}

TEST(Symmetry, PlacingAgainForgetsTheDrive) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation used(Tm27(), *ground), fresh(Tm27(), *ground);
  used.Place(Eigen::Vector2d::Zero(), 0);
  while (used.time() < 2) used.Advance({.steer = 0.2, .engine_torque = 80});
  used.Place({5, 5}, 1);
  fresh.Place({5, 5}, 1);
  EXPECT_EQ(used.StateHash(), fresh.StateHash());
  used.Advance({.engine_torque = 20});
  fresh.Advance({.engine_torque = 20});
  EXPECT_EQ(used.StateHash(), fresh.StateHash());
}

}  // namespace
}  // namespace dbd
