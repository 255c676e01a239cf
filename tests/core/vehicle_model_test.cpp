#include <dbd/core/units.h>
#include <dbd/core/vehicle_model.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(VehicleModel, MassIsTheSumOfItsBodies) {
  EXPECT_NEAR(Tm27().total_mass(), 612.9 + 2 * 28.55 + 2 * 40, 1e-9);
}

TEST(VehicleModel, WheelbaseAndTrackComeFromTheAxles) {
  EXPECT_DOUBLE_EQ(Tm27().wheelbase(), 2.032);
  EXPECT_DOUBLE_EQ(Tm27().mean_track(), 1.508);
}

TEST(VehicleModel, MassCenterHeightWeighsChassisAndWheels) {
  // Wheel centres at 0.310544 m (front) and 0.32068 m (rear) above ground, chassis at 0.475 m:
  // (612.9 * 0.475 + 57.1 * 0.310544 + 80 * 0.32068) / 750 = (291.1275 + 17.7321 + 25.6544) / 750.
  EXPECT_NEAR(Tm27().mass_center_height(), 334.5140 / 750, 1e-6);
}

TEST(VehicleModel, TurningRadiusFollowsFromTheSteeringAngle) {
  // L / tan(32 deg) = 2.032 / 0.624869 = 3.25188 m, and 15 % for control.
  EXPECT_NEAR(Tm27().min_turning_radius(), 1.15 * 3.25188, 1e-4);
}

TEST(VehicleModel, AllWheelSteeringTurnsTighter) {
  VehicleModel vehicle = Tm27();
  const double before = vehicle.min_turning_radius();
  vehicle.axles[0].steer_ratio = -1;
  vehicle.axles[0].max_steer = vehicle.axles[1].max_steer;
  // Without a fixed axle the distances count from the reference point; none lies farther away.
  EXPECT_LE(vehicle.min_turning_radius(), before + 1e-12);
}

TEST(VehicleModel, WithoutSteeringThereIsNoTurning) {
  VehicleModel vehicle = Tm27();
  vehicle.axles[1].steer_ratio = 0;
  EXPECT_TRUE(std::isinf(vehicle.min_turning_radius()));
}

TEST(Units, ConvertBothWays) {
  EXPECT_NEAR(Degrees(180), 3.14159265358979, 1e-14);
  EXPECT_DOUBLE_EQ(ToDegrees(Degrees(32)), 32);
  EXPECT_DOUBLE_EQ(ToRpm(Rpm(3500)), 3500);
  EXPECT_NEAR(Psi(25), 172368.925, 1e-6);
  EXPECT_DOUBLE_EQ(Inches(80), 2.032);
  EXPECT_DOUBLE_EQ(KilometersPerHour(36), 10);
  EXPECT_DOUBLE_EQ(Kilopascals(900), 9e5);
}

}  // namespace
}  // namespace dbd
