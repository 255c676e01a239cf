#include "suspension.h"

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

// A light axle on a chassis whose centre of mass is 1 m ahead of the reference point.
VehicleModel ChassisWithAxle(double steer_ratio) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"chassis", 100, Eigen::Vector3d::Ones(), {1, 0, 0.5}});
  AxleModel axle;
  axle.name = "rear";
  axle.steer_ratio = steer_ratio;
  vehicle.axles.push_back(axle);
  IndependentSuspension suspension;
  suspension.carrier_mass = 10;
  suspension.links.push_back({"arm", {0.5, 0.25, 0.1}, {0, -0.2, 0.05}});
  suspension.link_rate = {1e5, 100};
  suspension.spring.mount = {0.1, 0.3, 0.6};
  suspension.spring.pivot = {0.5, 0.25, 0.1};
  suspension.spring.hub_point = {0, -0.2, 0};
  suspension.spring.lever = 0.5;
  suspension.spring.rate = {2e4, 300};
  suspension.toe = {3e4, 150};
  AddIndependentAxle(suspension, {0, 0.7, 0}, WheelModel{}, vehicle);
  return vehicle;
}

TEST(Suspension, AddsTwoCarriersMirrored) {
  const VehicleModel v = ChassisWithAxle(0);
  ASSERT_EQ(v.bodies.size(), 3u);
  EXPECT_EQ(v.bodies[1].name, "rear left carrier");
  EXPECT_EQ(v.bodies[2].name, "rear right carrier");
  EXPECT_EQ(v.bodies[1].p_RB, Eigen::Vector3d(0, 0.7, 0));
  EXPECT_EQ(v.bodies[2].p_RB, Eigen::Vector3d(0, -0.7, 0));
  EXPECT_EQ(v.axles[0].left, 0);
  EXPECT_EQ(v.axles[0].right, 1);
}

TEST(Suspension, PointsAreRelativeToTheirBodies) {
  const VehicleModel v = ChassisWithAxle(0);
  ASSERT_EQ(v.links.size(), 2u);
  EXPECT_EQ(v.links[0].p_A, Eigen::Vector3d(-0.5, 0.25, -0.4));  // (0.5, 0.25, 0.1) - (1, 0, 0.5)
  EXPECT_EQ(v.links[1].p_A, Eigen::Vector3d(-0.5, -0.25, -0.4));
  EXPECT_EQ(v.links[0].p_B, Eigen::Vector3d(0, -0.2, 0.05));
  EXPECT_EQ(v.links[1].p_B, Eigen::Vector3d(0, 0.2, 0.05));
  EXPECT_EQ(v.springs[1].p_A, Eigen::Vector3d(-0.9, -0.3, 0.6 - 0.5));
}

TEST(Suspension, ToeIsSteeredOnSteeringAxlesOnly) {
  const VehicleModel fixed = ChassisWithAxle(0), steered = ChassisWithAxle(1);
  ASSERT_EQ(fixed.joints.size(), 2u);  // no camber stiffness was given
  EXPECT_EQ(fixed.joints[0].steered_wheel, -1);
  EXPECT_EQ(steered.joints[0].steered_wheel, 0);
  EXPECT_EQ(steered.joints[1].steered_wheel, 1);
}

TEST(Suspension, Tm27MotionRatios) {
  // Spring force * motion ratio carries wheel load less carrier weight:
  // front (1439.977 - 28.55 * 9.81) / 2848.872 = 0.40714, rear (2238.773 - 392.4) / 3822.042.
  const VehicleModel& v = Tm27();
  const auto force = [&](int i) {
    const SpringModel& s = v.springs[static_cast<std::size_t>(i)];
    const Eigen::Vector3d p_RA = v.bodies[0].p_RB + s.p_A, p_RQ = v.bodies[0].p_RB + s.p_Q;
    const Eigen::Vector3d p_RP = v.bodies[static_cast<std::size_t>(s.body_b)].p_RB + s.p_B;
    const double length = ((1 - s.lever) * p_RQ + s.lever * p_RP - p_RA).norm();
    return s.stiffness * (s.free_length - length);
  };
  EXPECT_NEAR((1439.977 - 28.55 * 9.81) / force(2), 0.40714, 2e-4);
  EXPECT_NEAR((2238.773 - 40 * 9.81) / force(0), 0.48309, 2e-4);
}

}  // namespace
}  // namespace dbd
