#include "axle_swing.h"

#include <dbd/core/connection.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

const AxleModel& AxleOf(const VehicleModel& vehicle, const std::string& name) {
  for (const AxleModel& axle : vehicle.axles) {
    if (axle.name == name) return axle;
  }
  throw std::out_of_range(name);
}

TEST(AxleSwing, PivotedAxleTurnsAboutItsPin) {
  const auto tractor = LoadVehicle("tractor");
  const auto swing = SwingOf(*tractor, AxleOf(*tractor, "front"));
  ASSERT_TRUE(swing);
  EXPECT_NEAR(swing->center_R.z(), 0.6, 1e-3);
  EXPECT_NEAR(swing->center_R.y(), 0, 1e-6);
  // Two springs of 100 N/m, 0.35 m to the sides: 2 * 100 * 0.35^2 = 24.5 N m/rad.
  EXPECT_NEAR(swing->stiffness, 24.5, 0.5);
  EXPECT_TRUE(SwingsFreely(*tractor, AxleOf(*tractor, "front")));
}

TEST(AxleSwing, BoltedOnAndSprungAxlesDoNotSwing) {
  const auto tractor = LoadVehicle("tractor");
  EXPECT_FALSE(SwingsFreely(*tractor, AxleOf(*tractor, "rear")));
  for (const char* name : {"utility-4x4", "truck-6x6", "small-ugv", "tomcar-tm27"}) {
    const auto vehicle = LoadVehicle(name);
    for (const AxleModel& axle : vehicle->axles) {
      EXPECT_FALSE(SwingsFreely(*vehicle, axle)) << name << " " << axle.name;
    }
  }
}

TEST(AxleSwing, IndependentWheelsHaveNoAxle) { EXPECT_FALSE(SwingOf(Tm27(), Tm27().axles[0])); }

TEST(AxleSwing, SpringsOfABeamAxleGiveItsRollStiffness) {
  // A beam held sideways and fore and aft at its middle by stiff links, on two springs of 20 kN/m,
  // 0.4 m to the sides: 2 * 20e3 * 0.4^2 = 6400 N m/rad.
  VehicleModel vehicle;
  vehicle.bodies.push_back({"chassis", 1000, {1, 1, 1}, {0, 0, 1}});
  vehicle.bodies.push_back({"beam", 100, {1, 1, 1}, {1, 0, 0.4}});
  AddConnection({.name = "pin",
                 .kind = ConnectionKind::kRevolute,
                 .body_b = 1,
                 .p_R = {1, 0, 0.7},
                 .axis = {1, 0, 0},
                 .base = 0.3,
                 .stiffness = 1e7,
                 .damping = 0},
                vehicle);
  for (const double y : {0.4, -0.4}) {
    SpringModel spring;
    spring.body_b = 1;
    spring.p_A = {1, y, 0};
    spring.p_B = {0, y, 0.1};
    spring.stiffness = 20e3;
    vehicle.springs.push_back(spring);
  }
  vehicle.wheels.resize(2);
  vehicle.wheels[0].body = vehicle.wheels[1].body = 1;
  AxleModel axle;
  axle.right = 1;
  const auto swing = SwingOf(vehicle, axle);
  ASSERT_TRUE(swing);
  EXPECT_NEAR(swing->stiffness, 6400, 10);
  EXPECT_NEAR(swing->center_R.z(), 0.7, 1e-2);
}

}  // namespace
}  // namespace dbd
