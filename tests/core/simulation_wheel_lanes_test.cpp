#include <dbd/core/vehicle_database.h>
#include <gtest/gtest.h>

#include "support/core_drive.h"
#include "support/core_trace.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

constexpr double kRoundOff = 1e-9;  // [m], [rad] or a share

/// The same drive with the wheels one after the other and side by side.
struct Pair {
  Simulation reference;
  Simulation lanes;

  Pair(const VehicleModel& vehicle, const Ground& ground)
      : reference(vehicle, ground), lanes(vehicle, ground, {.wheel_lanes = true}) {
    EXPECT_TRUE(lanes.wheel_lanes());
    reference.Place({0, 0}, 0.3);
    lanes.Place({0, 0}, 0.3);
  }

  void ExpectSame(const std::string& of) const {
    EXPECT_LT((reference.Chassis().p_WB - lanes.Chassis().p_WB).norm(), kRoundOff) << of;
    EXPECT_NEAR(reference.Chassis().yaw, lanes.Chassis().yaw, kRoundOff) << of;
    EXPECT_NEAR(reference.drive_energy(), lanes.drive_energy(),
                kRoundOff * (1 + reference.drive_energy()))
        << of;
  }
};

TEST(SimulationWheelLanes, ScenariosAgreeToRoundOff) {
  for (const std::string& name : ScenarioNames()) {
    const Scenario scenario = MakeScenario(name);
    const auto reference = DriveScenario(scenario, Tm27());
    const auto lanes = DriveScenario(scenario, Tm27(), {.wheel_lanes = true});
    ASSERT_EQ(reference.size(), lanes.size());
    for (std::size_t i = 0; i < reference.size(); ++i) {
      ASSERT_NEAR(reference[i].p_WB.z(), lanes[i].p_WB.z(), kRoundOff) << name << " step " << i;
      ASSERT_NEAR(reference[i].pitch, lanes[i].pitch, kRoundOff) << name << " step " << i;
    }
  }
}

TEST(SimulationWheelLanes, EveryVehicleDrivesTheSameCurve) {
  const auto ground = MakeRandomGround(-100, 0.05, 0.5, 7);
  for (const std::string& name : BuiltInVehicleNames()) {
    const auto vehicle = LoadVehicle(name);
    Pair pair(*vehicle, *ground);
    for (Simulation* s : {&pair.reference, &pair.lanes}) {
      for (int i = 0; i < 300; ++i) s->Advance({.steer = 0.2, .engine_torque = 60});
      for (int i = 0; i < 100; ++i) s->Advance({.steer = -0.1, .brake = 0.4});
    }
    pair.ExpectSame(name);
    EXPECT_GT(pair.lanes.Chassis().p_WB.head<2>().norm(), 0.1) << name;
  }
}

TEST(SimulationWheelLanes, ReportsWhatTheReferenceReports) {
  const auto ground = MakePlaneGround(0.1, 0.05);
  const VehicleModel& vehicle = Tm27();
  Pair pair(vehicle, *ground);
  for (Simulation* s : {&pair.reference, &pair.lanes}) {
    for (int i = 0; i < 50; ++i) s->Advance({.engine_torque = 40});
  }
  for (int i = 0; i < 4; ++i) {
    const WheelView a = pair.reference.Wheel(i), b = pair.lanes.Wheel(i);
    EXPECT_NEAR(a.load, b.load, 1e-6);
    EXPECT_NEAR(a.spin, b.spin, kRoundOff);
    EXPECT_NEAR(a.net_traction, b.net_traction, 1e-6);
    EXPECT_LT((a.contact_W - b.contact_W).norm(), kRoundOff);
  }
  for (int i = 0; i < static_cast<int>(vehicle.springs.size()); ++i) {
    EXPECT_NEAR(pair.reference.SpringForce(i), pair.lanes.SpringForce(i), 1e-6);
  }
  for (int i = 0; i < static_cast<int>(vehicle.links.size()); ++i) {
    EXPECT_NEAR(pair.reference.LinkForce(i), pair.lanes.LinkForce(i), 1e-6);
  }
  EXPECT_NEAR(pair.reference.VerticalAcceleration(), pair.lanes.VerticalAcceleration(), 1e-6);
  EXPECT_DOUBLE_EQ(pair.reference.time(), pair.lanes.time());
  EXPECT_TRUE(pair.lanes.IsSane());
}

TEST(SimulationWheelLanes, ComparisonsAndOddVehiclesKeepTheReference) {
  const auto ground = MakePlaneGround(0, 0);
  const Simulation disc(Tm27(), *ground, {.wheel_lanes = true, .tire = TireKind::kVerticalDisc});
  EXPECT_FALSE(disc.wheel_lanes());
  VehicleModel joined = Tm27();
  LinkModel anti_roll;
  anti_roll.body_a = 1, anti_roll.body_b = 2;
  joined.links.push_back(anti_roll);
  EXPECT_FALSE(Simulation(joined, *ground, {.wheel_lanes = true}).wheel_lanes());
}

}  // namespace
}  // namespace dbd
