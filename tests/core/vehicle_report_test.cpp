#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_report.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

const VehicleReport& Report() {
  static const VehicleReport report = CheckVehicle(Tm27());
  return report;
}

const VibrationMode* Find(const std::string& shape) {
  for (const VibrationMode& mode : Report().modes) {
    if (mode.shape == shape) return &mode;
  }
  return nullptr;
}

TEST(VehicleReport, StaticsOfTheSettledVehicle) {
  EXPECT_NEAR(Report().mass, 750, 1e-9);
  EXPECT_LT(std::abs(Report().settled_height_error), 2e-3);
  EXPECT_LT(std::abs(Report().settled_pitch), Degrees(0.05));
  ASSERT_EQ(Report().wheel_loads.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double load = i < 2 ? 2238.773 : 1439.977;
    EXPECT_NEAR(Report().wheel_loads[i], load, 0.005 * load);
    EXPECT_NEAR(Report().tire_deflections[i], load / Tm27().wheels[i].tire.stiffness, 1e-4);
    EXPECT_NEAR(Report().spring_forces[i], i < 2 ? 3822.042 : 2848.872, 30);
  }
}

TEST(VehicleReport, BounceAndPitch) {
  const VibrationMode* bounce = Find("chassis z");
  const VibrationMode* pitch = Find("chassis pitch");
  ASSERT_NE(bounce, nullptr);
  ASSERT_NE(pitch, nullptr);
  EXPECT_GT(bounce->frequency, 1.8);
  EXPECT_LT(bounce->frequency, 2.0);
  EXPECT_GT(pitch->frequency, 1.95);
  EXPECT_LT(pitch->frequency, 2.15);
}

TEST(VehicleReport, WheelHop) {
  int hops = 0;
  for (const VibrationMode& mode : Report().modes) {
    if (!mode.shape.ends_with("carrier z")) continue;
    EXPECT_GT(mode.frequency, 11) << mode.shape;
    EXPECT_LT(mode.frequency, 18.5) << mode.shape;
    EXPECT_GT(mode.damping, 0.05);
    ++hops;
  }
  EXPECT_GE(hops, 2);
}

TEST(VehicleReport, EveryModeIsDampedAndSorted) {
  ASSERT_FALSE(Report().modes.empty());
  double last = 0;
  for (const VibrationMode& mode : Report().modes) {
    EXPECT_GT(mode.damping, 0) << mode.shape << " " << mode.frequency;
    EXPECT_GE(mode.frequency, last);
    last = mode.frequency;
  }
}

TEST(VehicleReport, StepsAndLimits) {
  EXPECT_NEAR(Report().critical_translational, 7.55645e-3, 5e-9);
  EXPECT_NEAR(Report().critical_rotational, 6.18e-3, 5e-6);
  EXPECT_GT(Report().fastest_mode_limit, Tm27().steps.construction);
  EXPECT_NEAR(Report().top_speed, 18.495, 0.002);
  EXPECT_NEAR(ToDegrees(Report().stability_angle), 59.394, 0.001);
  EXPECT_NEAR(Report().min_turning_radius, 3.73966, 1e-4);
  EXPECT_NEAR(Report().traction_grade, std::atan(0.481027), 1e-5);
}

TEST(VehicleReport, PowerGradeByHand) {
  // Largest torque 89.419 * 3 * 6.429 = 1724.6 N m at radius 0.324421 m: 5316 N, less 0.04 of the
  // weight (294.3 N) = 5022 N of 7357.5 N: asin(0.6825) = 43.04 deg.
  EXPECT_NEAR(ToDegrees(Report().power_grade), 43.04, 0.1);
}

}  // namespace
}  // namespace dbd
