#include "trim.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_printed.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

// By hand for the TM27, total mass 750 kg, centre of mass of chassis 0.784 m, front wheels (57.1
// kg) 2.032 m ahead of the rear ones: x = (612.9 * 0.784 + 57.1 * 2.032) / 750 = 0.795387 m;
// front load 750 * 9.81 * 0.795387 / 2.032 / 2 = 1439.98 N per wheel.
constexpr double kFrontLoad = 1439.977, kRearLoad = 2238.773;

TEST(Trim, WheelLoads) {
  EXPECT_NEAR(Tm27().wheels[0].static_load, kRearLoad, 1e-3);
  EXPECT_NEAR(Tm27().wheels[1].static_load, kRearLoad, 1e-3);
  EXPECT_NEAR(Tm27().wheels[2].static_load, kFrontLoad, 1e-3);
  EXPECT_NEAR(Tm27().wheels[3].static_load, kFrontLoad, 1e-3);
}

TEST(Trim, WheelCentresStandOnTheirDeflectedTires) {
  // Radius less load / stiffness: 0.3175 - 1439.977 / 207021 and 0.3302 - 2238.773 / 235152.
  const VehicleModel& v = Tm27();
  EXPECT_NEAR(v.reference_height + v.bodies[v.wheels[2].body].p_RB.z(), 0.310544, 1e-6);
  EXPECT_NEAR(v.reference_height + v.bodies[v.wheels[0].body].p_RB.z(), 0.32068, 1e-6);
}

TEST(Trim, SpringFreeLengths) {
  EXPECT_NEAR(Tm27().springs[0].free_length, 0.621398, 1e-5);
  EXPECT_NEAR(Tm27().springs[1].free_length, 0.621398, 1e-5);
  EXPECT_NEAR(Tm27().springs[2].free_length, 0.440861, 1e-5);
  EXPECT_NEAR(Tm27().springs[3].free_length, 0.440861, 1e-5);
}

TEST(Trim, SpringForcesInTheDesignPose) {
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(Tm27(), *ground);
  scene.Evaluate();
  for (const int i : {0, 1}) EXPECT_NEAR(scene.work.spring_force[i], 3822.042, 1);
  for (const int i : {2, 3}) EXPECT_NEAR(scene.work.spring_force[i], 2848.872, 1);
}

TEST(Trim, LeftAndRightAreEqual) {
  const VehicleModel& v = Tm27();
  EXPECT_NEAR(v.wheels[0].static_load, v.wheels[1].static_load, 1e-9);
  EXPECT_NEAR(v.springs[2].free_length, v.springs[3].free_length, 1e-12);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(v.links[i].free_length, v.links[4 + i].free_length, 1e-12);
  }
  for (std::size_t i = 8; i < 13; ++i) {  // four arm links and a tie rod on each side
    EXPECT_NEAR(v.links[i].free_length, v.links[5 + i].free_length, 1e-12);
  }
}

// The trim solves each carrier under its exact static load; the engine's tires, sampled from the
// ground, may differ from it by the 0.5 % allowed to the contact.
TEST(Trim, DesignPoseIsInEquilibrium) {
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(Tm27(), *ground);
  scene.Evaluate();
  for (std::size_t i = 0; i < Tm27().bodies.size(); ++i) {
    const double weight = Tm27().bodies[i].mass * kGravity;
    const Wrench<double>& w = scene.work.wrench[i];
    EXPECT_NEAR(w.f_W.x, 0, 1e-6) << i;
    EXPECT_NEAR(w.f_W.y, 0, 1e-6) << i;
    EXPECT_NEAR(w.f_W.z, weight, 0.005 * kRearLoad) << i;
    // Moments of the tire error: 0.5 % of the load on the lever of the half track or wheelbase.
    EXPECT_LT(ToEigen(w.t_W).norm(), 0.005 * kRearLoad * 1.5) << i;
  }
}

TEST(Trim, WithTheExactLoadsTheResidualIsRoundOff) {
  VehicleModel v = Tm27();
  const auto sky = MakePlaneGround(0, 0);
  EngineScene scene(v, *sky);
  for (BodyState<double>& b : scene.state.bodies) b.p_WB.z += 100;  // no tire touches
  scene.Evaluate();
  for (const WheelModel& wheel : v.wheels) {
    Wrench<double>& w = scene.work.wrench[static_cast<std::size_t>(wheel.body)];
    w.Add({0, 0, wheel.static_load}, FromEigen(wheel.p_BH));
  }
  for (std::size_t i = 0; i < v.bodies.size(); ++i) {
    const Eigen::Vector3d force = ToEigen(scene.work.wrench[i].f_W);
    const Eigen::Vector3d weight(0, 0, v.bodies[i].mass * kGravity);
    EXPECT_LT((force - weight).norm(), 1e-6) << i;
    EXPECT_LT(ToEigen(scene.work.wrench[i].t_W).norm(), 1e-6) << i;
  }
}

TEST(Trim, RefusesAVehicleThatTipsOver) {
  VehicleModel v = Tm27();
  v.bodies[0].p_RB.x() = -0.5;
  const std::string message = InputErrorOf([&] { TrimWheelLoads("test", v); });
  EXPECT_NE(message.find("wheel \"front left\" carries"), std::string::npos) << message;
  EXPECT_NE(message.find("must lie between the axles"), std::string::npos);
}

TEST(Trim, GivenFreeLengthsAreKept) {
  VehicleModel v = Tm27();
  v.springs[0].free_length = 0.7;
  TrimFreeLengths(v);
  EXPECT_EQ(v.springs[0].free_length, 0.7);
}

TEST(Trim, ThreeAxlesShareTheWeightEvenlyWhereStaticsLeavesItOpen) {
  VehicleModel v = Tm27();
  // A third axle half-way, with a copy of the front's bodies: loads must be positive and balance.
  for (const int wheel : {2, 3}) {
    BodyModel body = v.bodies[static_cast<std::size_t>(v.wheels[wheel].body)];
    body.p_RB.x() = 1.0;
    WheelModel middle = v.wheels[static_cast<std::size_t>(wheel)];
    middle.body = static_cast<int>(v.bodies.size());
    v.bodies.push_back(body);
    v.wheels.push_back(middle);
  }
  TrimWheelLoads("test", v);
  double sum = 0, moment = 0, mass_moment = 0;
  for (const WheelModel& wheel : v.wheels) {
    EXPECT_GT(wheel.static_load, 0);
    sum += wheel.static_load;
    moment += wheel.static_load * v.bodies[static_cast<std::size_t>(wheel.body)].p_RB.x();
  }
  for (const BodyModel& body : v.bodies) mass_moment += body.mass * body.p_RB.x();
  EXPECT_NEAR(sum, v.total_mass() * kGravity, 1e-6);
  EXPECT_NEAR(moment, mass_moment * kGravity, 1e-6);
}

}  // namespace
}  // namespace dbd
