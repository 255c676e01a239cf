#include "held_tire.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/core_engine.h"
#include "support/core_trace.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// A mass that rides on one tire, without suspension.
VehicleModel MassOnATire(double tire_step) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"mass", 150, {50, 50, 50}, {0, 0, 0}});
  WheelModel wheel = Tm27().wheels[2];
  wheel.body = wheel.axle = wheel.reaction_body = 0;
  wheel.p_BH.setZero();
  vehicle.wheels.push_back(wheel);
  vehicle.steps = {1e-3, 1e-3, tire_step, 4e-3};
  return vehicle;
}

/// Rate at which the bounce of that mass dies away [1/s], from its peaks.
double BounceDecay(TireScheme scheme, double tire_step) {
  const VehicleModel vehicle = MassOnATire(tire_step);
  const auto ground = MakePlaneGround(0, 0);
  const TireModel& tire = vehicle.wheels[0].tire;
  const double rest = tire.radius - 150 * kGravity / tire.stiffness;
  const EngineModel engine(vehicle);
  EngineState<double> state = StateOfBodies(vehicle);
  state.wheels.assign(1, {});
  Workspace<double> work(vehicle);
  HeldWrenches held;
  state.bodies[0].p_WB.z = rest + 2e-3;
  double first = 0, last = 0, first_time = 0, last_time = 0;
  for (double before = 0, two_before = 0; state.step < 1000; ++state.step) {
    if (scheme == TireScheme::kHold) {
      EvaluateForcesHeld(engine, *ground, {}, state, work, held);
    } else {
      EvaluateForces(engine, *ground, {}, state, work);
    }
    IntegrateBodies(vehicle, kGravity, engine.step, work, state);
    const double z = state.bodies[0].p_WB.z - rest;
    if (state.step > 20 && before > two_before && before >= z) {
      (first == 0 ? first : last) = before;
      (last == 0 ? first_time : last_time) = 1e-3 * static_cast<double>(state.step);
    }
    two_before = before;
    before = z;
  }
  return std::log(first / last) / (last_time - first_time);
}

// Held over T in steps of h, a spring's force is (T - h)/2 old on average: k (z - z' (T - h)/2), a
// damper of -k (T - h)/2. With k = 207,021 N/m, c = 500 N s/m, m = 150 kg and h = 1 ms the decay
// (c - k (T - h)/2) / 2m falls from 1.67 /s at T = h to 1.32 /s at 2 ms and 0.63 /s at 4 ms; at 6
// ms it is negative, -0.06 /s: the bounce grows.
TEST(HeldTire, HoldingTheForceIsANegativeDamper) {
  const TireModel& tire = Tm27().wheels[2].tire;
  for (const double tire_step : {2e-3, 4e-3, 6e-3}) {
    const double lag = 0.5 * (tire_step - 1e-3);
    const double expected = (tire.damping - tire.stiffness * lag) / (2 * 150);
    EXPECT_NEAR(BounceDecay(TireScheme::kHold, tire_step), expected, 0.02) << tire_step;
    EXPECT_NEAR(BounceDecay(TireScheme::kSplit, tire_step), tire.damping / (2 * 150), 0.02);
  }
}

TEST(HeldTire, WithOneStepForAllBothSchemesAgree) {
  const Scenario waves = MakeScenario("B");
  const VehicleModel vehicle = WithStepSizes(Tm27(), 2e-3, 2e-3);
  const auto split = HeightsAlong(DriveScenario(waves, vehicle), 25);
  SimulationOptions hold;
  hold.tire_scheme = TireScheme::kHold;
  EXPECT_LT(RmsDifference(HeightsAlong(DriveScenario(waves, vehicle, hold), 25), split), 1e-9);
}

TEST(HeldTire, CostsAccuracyInTheScenarios) {
  for (const std::string name : {"A", "B", "C"}) {
    const Scenario scenario = MakeScenario(name);
    const auto fine = DriveScenario(scenario, WithStepSizes(Tm27(), 0.25e-3, 0.25e-3));
    const double end = fine.back().p_WB.x() - 0.3;
    const auto error_of = [&](TireScheme scheme) {
      SimulationOptions options;
      options.tire_scheme = scheme;
      const auto drive = DriveScenario(scenario, WithStepSizes(Tm27(), 2e-3, 8e-3), options);
      return RmsDifference(HeightsAlong(drive, end), HeightsAlong(fine, end));
    };
    const double split = error_of(TireScheme::kSplit), hold = error_of(TireScheme::kHold);
    RecordProperty("split_um_" + name, static_cast<int>(1e6 * split));
    RecordProperty("hold_um_" + name, static_cast<int>(1e6 * hold));
    EXPECT_GT(hold, 1.5 * split) << name;
  }
}

}  // namespace
}  // namespace dbd
