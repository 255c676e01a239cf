#include "mujoco_vehicle.h"

#include <dbd/core/scenario_record.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/core_vehicle.h"
#include "suspension_corner.h"

namespace dbd {
namespace {

Scenario Standing() {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 2;
  return scenario;
}

std::vector<TrajectoryRow> Record(const Scenario& scenario, MujocoContact contact) {
  MujocoVehicle vehicle(scenario, Tm27(), contact);
  return RecordMujoco(scenario, vehicle);
}

struct Range {
  double least = 0, most = 0;
};

/// Once it drives.
Range RangeOf(const std::vector<TrajectoryRow>& rows, double TrajectoryRow::*signal) {
  Range range{1e9, -1e9};
  for (const TrajectoryRow& row : rows) {
    if (row.t < 2) continue;
    range.least = std::min(range.least, row.*signal);
    range.most = std::max(range.most, row.*signal);
  }
  return range;
}

double MeanHeight(const std::vector<TrajectoryRow>& rows) {
  double sum = 0;
  for (const TrajectoryRow& row : rows) sum += row.z_ref;
  return sum / static_cast<double>(rows.size());
}

// The design pose is the equilibrium of both: 750 kg stand 0.381 m high, wheel centres lower than
// their radius by static load over tire stiffness.
TEST(MujocoVehicle, StandsAsDbdDoesOnTireLikeContacts) {
  const Scenario scenario = Standing();
  MujocoVehicle vehicle(scenario, Tm27(), MujocoContact::kTire);
  const TrajectoryRow row = RecordMujoco(scenario, vehicle).back();
  EXPECT_NEAR(vehicle.GroundForce(), 750 * 9.81, 20);
  EXPECT_NEAR(row.z_ref, 0.381, 2e-4);
  EXPECT_NEAR(row.pitch, 0, 1e-4);
  EXPECT_NEAR(row.vx, 0, 1e-3);
  for (const int i : {0, 2}) {
    const WheelModel& wheel = Tm27().wheels[WheelOrder(Tm27())[i]];
    EXPECT_NEAR(row.wheel_height[i], wheel.tire.radius - wheel.static_load / wheel.tire.stiffness,
                2e-4);
    EXPECT_NEAR(row.spring_force[i], wheel.static_load - 9.81 * Tm27().bodies[wheel.body].mass, 5);
  }
}

// Rigid contacts give next to nothing: higher by the tires' deflection of 7 to 10 mm.
TEST(MujocoVehicle, RigidContactsStandHigherByTheTiresDeflection) {
  const TrajectoryRow row = Record(Standing(), MujocoContact::kRigid).back();
  EXPECT_NEAR(row.z_ref, 0.381 + 0.009, 0.002);
}

class MujocoDrives : public testing::TestWithParam<std::tuple<std::string, MujocoContact>> {};

// It really drives what dbd drives: as far, at that speed, and over the same ground. It has no
// rolling resistance and its tires no width.
TEST_P(MujocoDrives, AsFarAndAsHighAsDbd) {
  const auto& [name, contact] = GetParam();
  const Scenario scenario = MakeScenario(name);
  const auto peer = Record(scenario, contact), own = RecordScenario(scenario, Tm27());
  EXPECT_NEAR(peer.back().x_cg, own.back().x_cg, 0.025 * own.back().x_cg);
  EXPECT_NEAR(peer.back().vx, scenario.target_speed, 0.08 * scenario.target_speed);
  EXPECT_NEAR(MeanHeight(peer), MeanHeight(own), 0.02);
  const Range pitch = RangeOf(peer, &TrajectoryRow::pitch);
  const Range own_pitch = RangeOf(own, &TrajectoryRow::pitch);
  EXPECT_NEAR(pitch.most - pitch.least, own_pitch.most - own_pitch.least,
              0.3 * (own_pitch.most - own_pitch.least));
  const Range roll = RangeOf(peer, &TrajectoryRow::roll);
  EXPECT_LT(roll.most - roll.least, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, MujocoDrives,
                         testing::Combine(testing::Values("A", "B", "C", "D"),
                                          testing::Values(MujocoContact::kTire,
                                                          MujocoContact::kRigid)));

TEST(MujocoVehicle, ResetDrivesTheSameAgain) {
  Scenario scenario = MakeScenario("C");
  scenario.duration = 4;
  MujocoVehicle vehicle(scenario, Tm27(), MujocoContact::kTire);
  const double first = RecordMujoco(scenario, vehicle).back().x_cg;
  EXPECT_GT(first, 2);
  EXPECT_EQ(RecordMujoco(scenario, vehicle).back().x_cg, first);
}

}  // namespace
}  // namespace dbd
