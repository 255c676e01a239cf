#include <dbd/core/powertrain.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

const PowertrainModel& Tm27Powertrain() { return Tm27().powertrain; }

/// Wheel speed at which the engine turns at `rpm` in a gear.
double WheelSpeed(double rpm, int gear) {
  return Rpm(rpm) / (Tm27Powertrain().gear_ratios[static_cast<std::size_t>(gear)] * 6.429);
}

TEST(Powertrain, TorqueCurveByHand) {
  // T = -3e-6 n^2 + 0.0193 n + 58.378; peak at 0.0193 / 6e-6 = 3216.7 rpm: 58.378 + 31.041 N m.
  EXPECT_NEAR(FullThrottleTorque(Tm27Powertrain(), Rpm(3216.7)), 89.419, 1e-3);
  EXPECT_NEAR(FullThrottleTorque(Tm27Powertrain(), Rpm(2000)), 84.978, 1e-9);
  double peak = 0, at = 0;
  for (double rpm = 1500; rpm <= 3500; rpm += 1) {
    const double torque = FullThrottleTorque(Tm27Powertrain(), Rpm(rpm));
    if (torque > peak) peak = torque, at = rpm;
  }
  EXPECT_NEAR(peak, 89.4, 0.05);
  EXPECT_NEAR(at, 3217, 1);
}

TEST(Powertrain, NoTorqueBeyondTheRevLimitAndIdleTorqueBelowIdle) {
  EXPECT_EQ(FullThrottleTorque(Tm27Powertrain(), Rpm(3500.1)), 0);
  EXPECT_GT(FullThrottleTorque(Tm27Powertrain(), Rpm(3499.9)), 80);
  EXPECT_EQ(FullThrottleTorque(Tm27Powertrain(), 0),
            FullThrottleTorque(Tm27Powertrain(), Rpm(1500)));
}

TEST(Powertrain, LargestPowerIs32Kilowatts) {
  EXPECT_NEAR(FullThrottleTorque(Tm27Powertrain(), Rpm(3500)) * Rpm(3500) / 1e3, 32.7, 0.1);
}

TEST(Powertrain, TorqueIsMultipliedToTheWheels) {
  PowertrainState state;
  // 50 N m in first gear: 50 * 3.0 * 6.429 = 964.35 N m.
  const double torque = UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(2500, 0), 4e-3, state);
  EXPECT_NEAR(torque, 964.35, 1e-6);
  EXPECT_NEAR(state.engine_torque, 50, 1e-9);
  EXPECT_NEAR(ToRpm(state.engine_speed), 2500, 1e-6);
  EXPECT_NEAR(MaxWheelTorque(Tm27Powertrain()), 89.419 * 3 * 6.429, 0.5);
}

TEST(Powertrain, TorqueIsLimitedByTheCurveAndByEngineBraking) {
  PowertrainState state;
  UpdatePowertrain(Tm27Powertrain(), 1e4, WheelSpeed(2000, 0), 4e-3, state);
  EXPECT_NEAR(state.engine_torque, 84.978, 1e-6);
  UpdatePowertrain(Tm27Powertrain(), -1e4, WheelSpeed(2000, 0), 4e-3, state);
  EXPECT_NEAR(state.engine_torque, -20, 1e-9);
  UpdatePowertrain(Tm27Powertrain(), -1e4, 0, 4e-3, state);
  EXPECT_EQ(state.engine_torque, 0);  // the clutch slips: standing still is not turned backwards
}

TEST(Powertrain, ShiftsUpOneGearAtATime) {
  PowertrainState state;
  UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(3100, 0), 4e-3, state);
  EXPECT_EQ(state.gear, 1);
  UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(3100, 1), 4e-3, state);
  EXPECT_EQ(state.gear, 1);  // within the shift interval of 0.5 s
  for (int i = 0; i < 130; ++i) {
    UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(3100, 1), 4e-3, state);
  }
  EXPECT_EQ(state.gear, 2);
}

TEST(Powertrain, ShiftsDownAndStaysWithinItsGears) {
  PowertrainState state;
  state.gear = 4;
  for (int i = 0; i < 2000; ++i) UpdatePowertrain(Tm27Powertrain(), 5, 0.1, 4e-3, state);
  EXPECT_EQ(state.gear, 0);
  for (int i = 0; i < 2000; ++i) UpdatePowertrain(Tm27Powertrain(), 5, 1e3, 4e-3, state);
  EXPECT_EQ(state.gear, 4);
}

TEST(Powertrain, NoHuntingBetweenGears) {
  // From 3000 rpm up: 3000 * 2.5 / 3 = 2500 rpm, above the 1800 rpm of shifting down; every step.
  const PowertrainModel& p = Tm27Powertrain();
  for (std::size_t i = 0; i + 1 < p.gear_ratios.size(); ++i) {
    EXPECT_GT(ToRpm(p.upshift_speed) * p.gear_ratios[i + 1] / p.gear_ratios[i],
              ToRpm(p.downshift_speed));
  }
}

TEST(Powertrain, ClutchEngagesExponentially) {
  PowertrainState state;
  UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(3100, 0), 4e-3, state);  // shifts
  for (int i = 1; i <= 100; ++i) {
    const double time = 4e-3 * i;
    EXPECT_NEAR(state.engine_torque, 50 * (1 - std::exp(-time / 0.15)), 1e-9) << i;
    UpdatePowertrain(Tm27Powertrain(), 50, WheelSpeed(2600, 1), 4e-3, state);
  }
}

TEST(Powertrain, TopSpeedByHand) {
  // Rear rolling radius 0.324421 m from R 0.3302 m, deflection 2238.773 / 235152 = 9.5205 mm:
  // 2.5 * 0.3302 * 0.320680 / (0.4953 + 0.320680). 366.519 rad/s / 6.429 * 0.324421 = 18.495 m/s.
  EXPECT_NEAR(TopSpeed(Tm27()), 18.495, 0.002);
}

TEST(Powertrain, TractionPerEngineTorqueByHand) {
  // 3 * 6.429 / 0.324421 m, no losses.
  EXPECT_NEAR(TractionPerEngineTorque(Tm27()), 59.450, 0.005);
}

TEST(Powertrain, ReverseTurnsTheWheelsBackwards) {
  PowertrainState state;
  SelectDirection(true, state);
  EXPECT_EQ(state.time_in_gear, 0);  // the clutch opens
  state.time_in_gear = 1e3;
  // Geared like first gear unless the file says otherwise: 50 * 3.0 * 6.429 = 964.35 N m.
  const double torque = UpdatePowertrain(Tm27Powertrain(), 50, -WheelSpeed(2500, 0), 4e-3, state);
  EXPECT_NEAR(torque, -964.35, 1e-6);
  EXPECT_NEAR(ToRpm(state.engine_speed), 2500, 1e-6);
  // No shifting up, and the engine brakes a vehicle that backs down too fast.
  for (int i = 0; i < 1000; ++i) {
    UpdatePowertrain(Tm27Powertrain(), 50, -WheelSpeed(3300, 0), 4e-3, state);
  }
  EXPECT_EQ(state.gear, 0);
  EXPECT_GT(UpdatePowertrain(Tm27Powertrain(), -1e4, -WheelSpeed(2500, 0), 4e-3, state), 0);
  SelectDirection(false, state);
  EXPECT_FALSE(state.reverse);
  EXPECT_EQ(state.time_in_gear, 0);
}

}  // namespace
}  // namespace dbd
