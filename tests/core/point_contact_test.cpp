#include "point_contact.h"

#include <dbd/core/scenario.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_ground.h"
#include "support/core_moved_ground.h"

namespace dbd {
namespace {

constexpr double kStep = 1e-3;

/// A block of 100 kg on four skids, without wheels.
VehicleModel Block(double friction) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"block", 100, {5, 8, 10}, {0, 0, 0.2}});
  for (const double x : {0.4, -0.4}) {
    for (const double y : {0.3, -0.3}) {
      ContactModel skid;
      skid.p_B = {x, y, -0.2};
      skid.stiffness = skid.tangential_stiffness = 1e5;
      skid.damping = skid.tangential_damping = 1500;
      skid.friction = friction;
      vehicle.contacts.push_back(skid);
    }
  }
  return vehicle;
}

struct Scene {
  Scene(const VehicleModel& model, const Ground& surface)
      : vehicle(model), ground(surface), state(StateOfBodies(model)), work(model) {
    state.contacts.assign(model.contacts.size(), {});
    state.frictions.assign(model.frictions.size(), 0.0);
  }
  void Run(double time) {
    for (int i = 0; i < std::lround(time / kStep); ++i) {
      for (std::size_t b = 0; b < vehicle.bodies.size(); ++b) {
        work.R_WB[b] = RotationMatrix(state.bodies[b].q_WB);
        work.wrench[b].Clear();
      }
      AddContactsAndLoads(vehicle, ground, kStep, true, state, work);
      IntegrateBodies(vehicle, kGravity, kStep, work, state);
    }
  }
  /// Lays the block on the slope z = grade x.
  void LayOn(double grade) {
    const double c = 1 / std::sqrt(1 + grade * grade);
    const Eigen::AngleAxisd turn(-std::atan(grade), Eigen::Vector3d::UnitY());
    state.bodies[0].q_WB = FromEigen(Eigen::Quaterniond(turn));
    state.bodies[0].p_WB = {-0.2 * grade * c, 0, 0.2 * c};
  }
  const VehicleModel& vehicle;
  const Ground& ground;
  EngineState<double> state;
  Workspace<double> work;
};

TEST(PointContact, CarriesTheWeight) {
  const VehicleModel block = Block(0.5);
  const auto ground = MakePlaneGround(0, 0);
  Scene scene(block, *ground);
  scene.Run(2);
  // 981 N on four springs of 1e5 N/m: 2.45 mm deep.
  EXPECT_NEAR(scene.state.bodies[0].p_WB.z, 0.2 - 981.0 / 4e5, 2e-5);
  for (const double force : scene.work.contact_force) EXPECT_NEAR(force, 981.0 / 4, 0.5);
}

TEST(PointContact, HoldsBelowTheFrictionAngleWithoutCreep) {
  const VehicleModel block = Block(0.5);
  const auto ground = MakePlaneGround(0.4, 0);
  Scene scene(block, *ground);
  scene.LayOn(0.4);
  scene.Run(3);
  const double x = scene.state.bodies[0].p_WB.x;
  scene.Run(20);
  EXPECT_NEAR(scene.state.bodies[0].p_WB.x, x, 1e-6);
}

TEST(PointContact, SlidesBeyondItWithTheRestOfGravity) {
  const VehicleModel block = Block(0.3);
  const auto ground = MakePlaneGround(0.6, 0);
  Scene scene(block, *ground);
  scene.LayOn(0.6);
  scene.Run(1);
  const double before = Norm(scene.state.bodies[0].v_WB);
  scene.Run(1);
  // g (sin a - mu cos a), tan a = 0.6: 9.81 (0.5145 - 0.2572) = 2.523 m/s^2
  const double c = 1 / std::sqrt(1.36);
  EXPECT_NEAR(Norm(scene.state.bodies[0].v_WB) - before, kGravity * (0.6 - 0.3) * c, 0.05);
}

/// Normal under the first skid of the block lying somewhere with some heading.
Eigen::Vector3d NormalUnder(const Ground& ground, double heading) {
  const VehicleModel block = Block(0.5);
  Scene scene(block, ground);
  const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
  scene.state.bodies[0].q_WB = FromEigen(Eigen::Quaterniond(turn));
  scene.state.bodies[0].p_WB = {0, 0, 0.2};
  scene.work.R_WB[0] = RotationMatrix(scene.state.bodies[0].q_WB);
  SamplePointContacts(block, ground, scene.work, scene.state);
  return ToEigen(scene.state.contacts[0].normal_W);
}

TEST(PointContact, NormalOfCurvedGroundDoesNotDependOnTheWorldsAxes) {
  const FunctionGround dome([](double x, double y) { return x * x + 0.5 * x * y - 2 * y * y; });
  const Eigen::Vector3d normal = NormalUnder(dome, 0);
  // At (0.4, 0.3): slopes 2 x + 0.5 y = 0.95 and 0.5 x - 4 y = -1.
  EXPECT_LT((normal - Eigen::Vector3d(-0.95, 1, 1).normalized()).norm(), 1e-9);
  const MovedGround turned(dome, 1.3, {0, 0, 0});
  const Eigen::AngleAxisd turn(1.3, Eigen::Vector3d::UnitZ());
  EXPECT_LT((NormalUnder(turned, 1.3) - turn * normal).norm(), 1e-9);
}

/// Level ground that knows its bound and counts the heights asked of it.
class CountingGround final : public Ground {
 public:
  void Heights(int count, const double*, const double*, double* z) const override {
    std::fill(z, z + count, 0.0);
    asked += count;
  }
  void Soils(int count, const double*, const double*, SoilSample* soil) const override {
    std::fill(soil, soil + count, SoilSample{});
  }
  void HighestWithin(double, int count, const double*, const double*, double* z) const override {
    std::fill(z, z + count, 0.0);
  }
  mutable int asked = 0;
};

TEST(PointContact, PointsHighAboveTheGroundAskForNoHeights) {
  const VehicleModel block = Block(0.5);
  const CountingGround ground;
  Scene scene(block, ground);
  scene.state.bodies[0].p_WB.z = 0.4;  // skids 0.2 m up
  scene.Run(kStep);
  EXPECT_EQ(ground.asked, 0);
  scene.state.bodies[0].p_WB.z = 0.3;
  scene.Run(kStep);
  EXPECT_EQ(ground.asked, 4 * 5);
  scene.Run(3);  // falls, and lies on its skids
  EXPECT_NEAR(scene.state.bodies[0].p_WB.z, 0.2 - 981.0 / 4e5, 2e-5);
}

TEST(PointContact, NeverPullsAndDoesNothingInTheAir) {
  const VehicleModel block = Block(0.5);
  const auto ground = MakePlaneGround(0, 0);
  Scene scene(block, *ground);
  scene.state.bodies[0].p_WB.z = 1;
  scene.state.bodies[0].v_WB.z = 3;
  scene.Run(0.1);
  EXPECT_NEAR(scene.state.bodies[0].v_WB.z, 3 - 0.1 * kGravity, 1e-9);
}

/// Two free bodies, the second pulled along x; dry friction of 50 N between them.
VehicleModel Pair(FrictionModel::Motion motion) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"a", 10, {1, 1, 1}, {0, 0, 0}});
  vehicle.bodies.push_back({"b", 10, {1, 1, 1}, {1, 0, 0}});
  FrictionModel friction;
  friction.motion = motion;
  friction.body_b = 1;
  friction.axis_a = {1, 0, 0};
  friction.limit = 50;
  friction.stiffness = 1e5;
  friction.damping = 500;
  vehicle.frictions.push_back(friction);
  return vehicle;
}

TEST(Friction, SticksBelowItsLimitAndSlipsAtIt) {
  VehicleModel vehicle = Pair(FrictionModel::Motion::kSliding);
  vehicle.loads.push_back({"pull", 1, {0, 0, 0}, {80, 0, 0}, {0, 0, 0}, false});
  const auto ground = MakePlaneGround(0, 0);
  Scene stuck(vehicle, *ground);
  stuck.Run(1);  // 80 N on 20 kg: 40 N are passed on, both at 4 m/s
  EXPECT_NEAR(stuck.state.bodies[0].v_WB.x, 4, 0.02);
  EXPECT_NEAR(stuck.state.bodies[1].v_WB.x, 4, 0.02);
  vehicle.loads[0].force.x() = 200;
  Scene slipping(vehicle, *ground);
  slipping.Run(1);  // 50 N are passed on: 5 and 15 m/s
  EXPECT_NEAR(slipping.state.bodies[0].v_WB.x, 5, 0.05);
  EXPECT_NEAR(slipping.state.bodies[1].v_WB.x, 15, 0.05);
}

TEST(Friction, TurningTorqueConservesAngularMomentum) {
  VehicleModel vehicle = Pair(FrictionModel::Motion::kTurning);
  const auto ground = MakePlaneGround(0, 0);
  Scene scene(vehicle, *ground);
  SetAngularVelocity(vehicle.bodies[1], {30, 0, 0}, scene.state.bodies[1]);
  scene.Run(0.1);  // 50 N m on 1 kg m^2 for 0.1 s: 5 rad/s
  EXPECT_NEAR(scene.state.bodies[1].w_WB.x, 25, 0.1);
  EXPECT_NEAR(scene.state.bodies[0].w_WB.x + scene.state.bodies[1].w_WB.x, 30, 1e-9);
  scene.Run(1);
  EXPECT_NEAR(scene.state.bodies[0].w_WB.x, 15, 0.05);
  EXPECT_NEAR(scene.state.bodies[1].w_WB.x, 15, 0.05);
}

TEST(AppliedLoad, TurnsWithItsBodyWhenAsked) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"a", 10, {1, 1, 1}, {0, 0, 0}});
  vehicle.loads.push_back({"thrust", 0, {0, 0.5, 0}, {10, 0, 0}, {0, 0, 2}, true});
  Workspace<double> work(vehicle);
  work.R_WB[0] = RotationMatrix(
      FromEigen(Eigen::Quaterniond(Eigen::AngleAxisd(Degrees(90), Eigen::Vector3d::UnitZ()))));
  AddAppliedLoads(vehicle, work);
  EXPECT_NEAR(work.wrench[0].f_W.y, 10, 1e-9);
  EXPECT_NEAR(work.wrench[0].f_W.x, 0, 1e-9);
  EXPECT_NEAR(work.wrench[0].t_W.z, 2 - 5, 1e-9);  // torque, and 10 N at 0.5 m left of the centre
}

}  // namespace
}  // namespace dbd
