#include <dbd/core/driver.h>
#include <dbd/core/driver_care.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

const CareOptions kCare;
const VehicleLimits kLimits;
constexpr double kStep = 4e-3;

/// Speed aimed for after `time` on the same going, where 6 m/s are allowed.
double SpeedAfter(const GoingView& going, double time, CareState state = {}) {
  double speed = 6;
  for (double t = 0; t < time; t += kStep) {
    speed = CarefulSpeed(kCare, kLimits, going, 6, kStep, state);
  }
  return speed;
}

TEST(DriverCare, RuleIsARamp) {
  const CareRule rule{0.2, 0.6, 0.5};
  EXPECT_EQ(CareShare(rule, 0), 1);
  EXPECT_EQ(CareShare(rule, 0.2), 1);
  EXPECT_DOUBLE_EQ(CareShare(rule, 0.4), 0.75);
  EXPECT_EQ(CareShare(rule, 0.6), 0.5);
  EXPECT_EQ(CareShare(rule, 5), 0.5);
}

TEST(DriverCare, GoodGoingChangesNothing) {
  EXPECT_EQ(SpeedAfter({}, 10), 6);
  EXPECT_EQ(
      SpeedAfter({.slip = 0.1, .sinkage = 0.02, .ground_slope = 0.2, .vertical_acceleration = 1.0},
                 10),
      6);
}

TEST(DriverCare, EachMeasureSlowsDown) {
  EXPECT_NEAR(SpeedAfter({.slip = 1}, 20), 6 * 0.5, 1e-9);
  EXPECT_NEAR(SpeedAfter({.slip = -1}, 20), 6 * 0.5, 1e-9);
  EXPECT_NEAR(SpeedAfter({.sinkage = kLimits.max_sinkage}, 20), 6 * 0.4, 1e-9);
  EXPECT_NEAR(SpeedAfter({.ground_slope = kLimits.max_slope}, 20), 6 * 0.6, 1e-9);
  EXPECT_NEAR(SpeedAfter({.vertical_acceleration = 5}, 20), 6 * 0.4, 1e-9);
}

TEST(DriverCare, TargetFallsAtTheGivenDecelerationAndRisesSlowly) {
  // 1.5 m/s^2 from 6 m/s; 0.1 of 6 m/s per second back.
  EXPECT_NEAR(SpeedAfter({.sinkage = 1}, 1), 4.5, 0.02);
  EXPECT_NEAR(SpeedAfter({}, 1, {.share = 0.4}), 3, 0.01);
  EXPECT_NEAR(SpeedAfter({}, 2, {.share = 0.4}), 3.6, 0.01);
}

TEST(DriverCare, NeverSlowerThanTheLeastSpeedForCaresSake) {
  const GoingView going{.slip = 1, .sinkage = 1, .ground_slope = 1, .vertical_acceleration = 10};
  CareState state;
  double speed = 0;
  for (int i = 0; i < 5000; ++i) {
    speed = CarefulSpeed(kCare, kLimits, going, 2, kStep, state);
  }
  EXPECT_EQ(speed, kCare.least_speed);
  EXPECT_EQ(CarefulSpeed(kCare, kLimits, going, 0.8, kStep, state), 0.8);
  EXPECT_EQ(CarefulSpeed(kCare, kLimits, going, 0, kStep, state), 0);
}

TEST(DriverCare, KeepsItsMomentumUphill) {
  EXPECT_EQ(SpeedAfter({.slip = 1, .ground_slope = 0.5, .climb = 0.5}, 10), 6);
  EXPECT_NEAR(SpeedAfter({.slip = 1, .climb = 0.15}, 20), 6 * 0.75, 1e-9);  // half-way
  EXPECT_NEAR(SpeedAfter({.slip = 1, .climb = -0.5}, 20), 6 * 0.5, 1e-9);
  EXPECT_NEAR(SpeedAfter({.climb = 0.5}, 1, {.share = 0.4}), 5.4, 0.02);
}

TEST(DriverCare, HoldsTheTorqueThatTheLowerSpeedNeeds) {
  // Slipping at the speed asked for: the integral of the speed error keeps what holding takes.
  Driver driver(Tm27(), {}, {.target_speed = 4});
  driver.SetStart({0, 0}, 0);
  DriverState state;
  state.integral = 50;
  state.care.share = 0.5;
  DriverView view;
  view.speed = 2;
  view.going.slip = 1;
  state.care.slip = 1;
  const DriverCommand command = driver.Update(view, kStep, state);
  EXPECT_NEAR(command.engine_torque, 50, 0.5);
  EXPECT_EQ(command.brake, 0);
}

}  // namespace
}  // namespace dbd
