#include <dbd/planner/drive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planner/candidate_test_terrain.h"

namespace dbd {
namespace {

using testing::HasSubstr;

/// Twelve seconds straight over waves of 4 m length across the way.
Rollout DriveOverWaves(double amplitude, double max_absorbed_power, double max_shock) {
  const Terrain terrain = SurfaceTerrain(280, 40, 0.5, [amplitude](double x, double) {
    return amplitude * std::cos(2 * std::numbers::pi * x / 4);
  });
  VehicleModel vehicle = *LoadVehicle("tomcar-tm27");
  vehicle.limits.max_absorbed_power = max_absorbed_power;
  vehicle.limits.max_shock = max_shock;
  DriveOptions options;
  options.duration = 12;
  options.stop_at_violation = true;
  return DrivePath(terrain, vehicle, Path(), {10, 10}, 0, options);
}

const LimitMargin& Margin(const Rollout& rollout, const std::string& name) {
  for (const LimitMargin& margin : rollout.margins) {
    if (margin.name == name) return margin;
  }
  throw std::out_of_range(name);
}

TEST(Judge, LevelGroundShakesNobody) {
  const Rollout rollout = DriveOverWaves(0, 6, 24.5);
  EXPECT_EQ(rollout.outcome, Outcome::kTimedOut);
  EXPECT_LT(Margin(rollout, "absorbed_power").worst, 0.1);
  EXPECT_LT(Margin(rollout, "shock").worst, 2);
}

TEST(Judge, MultipassDeepensTheRuts) {
  const Terrain terrain = SurfaceTerrain(100, 40, 0.5, [](double, double) { return 0.0; });
  const auto deepest = [&](double exponent) {
    DriveOptions options;
    options.duration = 2;
    options.sinkage.multipass_exponent = exponent;
    return Margin(DrivePath(terrain, *LoadVehicle("tomcar-tm27"), Path(), {10, 10}, 0, options),
                  "sinkage")
        .worst;
  };
  EXPECT_GT(deepest(3), deepest(0));
  EXPECT_GT(deepest(2), deepest(3));
}

TEST(Judge, WorstRideOfTheTraceIsTheCertificates) {
  const Rollout rollout = DriveOverWaves(0.04, 1e9, 1e9);
  double power = 0, shock = 0;
  for (const TraceSample& sample : rollout.trace) {
    power = std::max(power, sample.absorbed_power);
    shock = std::max(shock, sample.vertical_acceleration);
  }
  EXPECT_GT(power, 0.1);
  EXPECT_GE(Margin(rollout, "absorbed_power").worst, power);
  EXPECT_GE(Margin(rollout, "shock").worst, shock);
  EXPECT_GT(shock, 1);
}

TEST(Judge, RideAndShockEndADriveThatExceedsThem) {
  const Rollout rough = DriveOverWaves(0.04, 0.05, 1e9);
  EXPECT_EQ(rough.outcome, Outcome::kLimitExceeded);
  EXPECT_THAT(rough.reason, HasSubstr("absorbed_power"));
  EXPECT_THAT(rough.reason, HasSubstr(" W, limit 0.05 W"));
  const Rollout hard = DriveOverWaves(0.04, 1e9, 0.981);
  EXPECT_EQ(hard.outcome, Outcome::kLimitExceeded);
  EXPECT_THAT(hard.reason, HasSubstr(" g, limit 0.1 g"));
}

}  // namespace
}  // namespace dbd
