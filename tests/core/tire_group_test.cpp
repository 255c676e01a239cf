#include "tire_group.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(TireGroup, LocatesAHubThatTurnsOnItsBody) {
  WheelModel wheel;
  wheel.p_BH = {0, 0.5, 0};
  const Mat3<double> R_WB = RotationMatrix(
      FromEigen(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()))));
  EXPECT_EQ(ToEigen(LocateHub(wheel, R_WB, 0.3).y_W), ToEigen(R_WB.y));  // a joint steers
  wheel.steers_hub = true;
  const double angle = 0.3;
  const Vec3<double> y = LocateHub(wheel, R_WB, std::sin(angle)).y_W;
  // Body turned by 0.5, hub by another 0.3: the left axis points to (-sin 0.8, cos 0.8).
  EXPECT_NEAR(y.x, -std::sin(0.8), 1e-12);
  EXPECT_NEAR(y.y, std::cos(0.8), 1e-12);
}

TEST(TireGroup, WheelsInTheAirGetNoForceButTheirGyroscopicMoment) {
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(Tm27(), *ground);
  for (BodyState<double>& b : scene.state.bodies) b.p_WB.z += 10;
  scene.Evaluate();
  const std::vector<Wrench<double>> still = scene.work.wrench;
  scene.state.wheels[0].spin = 30;
  const int body = Tm27().wheels[0].body;
  SetAngularVelocity(Tm27().bodies[static_cast<std::size_t>(body)], {0, 0, 2},
                     scene.state.bodies[static_cast<std::size_t>(body)]);
  Workspace<double> work = scene.work;
  for (Wrench<double>& w : work.wrench) w.Clear();
  AddTireForces(scene.engine, scene.controls, 2e-3, scene.state, work);
  // -J Omega (w x y) = -1.6 * 30 * 2 (z x y) = +96 x: turning left lifts the left side.
  EXPECT_NEAR(work.wrench[static_cast<std::size_t>(body)].t_W.x, 96, 1e-9);
  EXPECT_EQ(work.wrench[static_cast<std::size_t>(body)].f_W.z, 0);
  EXPECT_EQ(scene.work.tires[0].load, 0);
}

TEST(TireGroup, DriveTorqueReactsOnTheChassis) {
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(Tm27(), *ground);
  for (BodyState<double>& b : scene.state.bodies) b.p_WB.z += 10;
  scene.Evaluate();
  const double before = scene.work.wrench[0].t_W.y;
  scene.controls.drive_torque[0] = 150;
  scene.Evaluate();
  EXPECT_NEAR(scene.work.wrench[0].t_W.y - before, -150, 1e-9);
}

TEST(TireGroup, ContactForceHasNoMomentAboutTheSpinAxis) {
  const auto ground = MakePlaneGround(0.2, 0);
  EngineScene scene(Tm27(), *ground);
  scene.Evaluate();
  const HubPose<double> hub{{0, 0, 0}, scene.work.R_WB[1].y};
  Workspace<double> work = scene.work;
  for (Wrench<double>& w : work.wrench) w.Clear();
  TireLaw<double> law{};
  law.normal_W = scene.state.wheels[0].contact.normal_W;
  law.forward_W = Normalized(Cross(hub.y_W, law.normal_W));
  law.left_W = Cross(law.normal_W, law.forward_W);
  law.load = 2000, law.resistance = -100, law.lateral = 300;
  ApplyTire(Tm27().wheels[0], law, hub, 500.0, 0.0, 0.0, scene.state.wheels[0],
            scene.state.bodies[1], work);
  EXPECT_NEAR(Dot(work.wrench[1].t_W, hub.y_W), 0, 1e-9);
  const Eigen::Vector3d expected =
      2000 * ToEigen(law.normal_W) + 400 * ToEigen(law.forward_W) + 300 * ToEigen(law.left_W);
  EXPECT_LT((ToEigen(work.wrench[1].f_W) - expected).norm(), 1e-9);
}

TEST(TireGroup, BrakeTorqueTurnsTheCarrierWithTheWheel) {
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(Tm27(), *ground);
  for (BodyState<double>& b : scene.state.bodies) b.p_WB.z += 10;
  scene.Evaluate();
  const double before = scene.work.wrench[1].t_W.y;
  scene.state.wheels[0].spin = 50;
  scene.controls.brake_torque[0] = 300;
  scene.Evaluate();
  // The brake slows forward rolling with -300 N m; the carrier feels the opposite.
  EXPECT_NEAR(scene.work.wrench[1].t_W.y - before, 300, 1e-9);
}

}  // namespace
}  // namespace dbd
