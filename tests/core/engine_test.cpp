#include "engine.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// The TM27 without dampers, far above the ground and without gravity: nothing takes energy.
VehicleModel Undamped() {
  VehicleModel v = Tm27();
  for (LinkModel& link : v.links) link.damping = 0;
  for (SpringModel& spring : v.springs) spring.damping = 0;
  for (AxisJointModel& joint : v.joints) joint.damping = 0;
  return v;
}

class FreeVehicle {
 public:
  FreeVehicle() : vehicle(Undamped()), ground(MakePlaneGround(0, 0)), scene(vehicle, *ground) {
    scene.engine.gravity = 0;
    for (BodyState<double>& b : scene.state.bodies) b.p_WB.z += 1000;
  }

  double Energy() const {
    return KineticEnergy(vehicle, scene.state) + ElasticEnergy(vehicle, scene.state);
  }

  /// Mean of the energy over the next `time` seconds.
  double MeanEnergy(double time) {
    double sum = 0;
    const auto steps = std::lround(time / scene.engine.step);
    for (long i = 0; i < steps; ++i) {
      scene.Step();
      sum += Energy();
    }
    return sum / static_cast<double>(steps);
  }

  /// About the point at which the vehicle was released.
  Eigen::Vector3d AngularMomentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
      const BodyState<double>& b = scene.state.bodies[i];
      const Eigen::Vector3d lever = ToEigen(b.p_WB) - Eigen::Vector3d(0, 0, 1000);
      sum += vehicle.bodies[i].mass * lever.cross(ToEigen(b.v_WB)) + ToEigen(b.h_WB);
    }
    return sum;
  }

  /// With these steps, and velocities brought back by half of one, as leapfrog keeps them.
  void StartWithStep(double step) {
    scene.engine.step = step;
    scene.Evaluate();
    for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
      BodyState<double>& b = scene.state.bodies[i];
      b.v_WB -= (0.5 * step / vehicle.bodies[i].mass) * scene.work.wrench[i].f_W;
      b.h_WB -= (0.5 * step) * scene.work.wrench[i].t_W;
    }
  }

  Eigen::Vector3d Momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
      sum += vehicle.bodies[i].mass * ToEigen(scene.state.bodies[i].v_WB);
    }
    return sum;
  }

  VehicleModel vehicle;
  std::shared_ptr<const Ground> ground;
  EngineScene scene;
};

// The released springs (53 J and 33 J each) and the pushes make it bounce, pitch, roll and turn.
TEST(Engine, EnergyOfTheFreeUndampedVehicleDoesNotDrift) {
  FreeVehicle free;
  BodyState<double>& chassis = free.scene.state.bodies[0];
  chassis.v_WB = {0, 0, 0.3};
  SetAngularVelocity(free.vehicle.bodies[0], {0.3, 0.2, 0.1}, chassis);
  const double first = free.MeanEnergy(2);
  free.MeanEnergy(26);
  const double last = free.MeanEnergy(2);
  RecordProperty("drift_ppm", static_cast<int>(std::lround(1e6 * (last / first - 1))));
  EXPECT_GT(first, 100);
  EXPECT_LT(std::abs(last / first - 1), 1e-3);
}

TEST(Engine, MomentaOfTheFreeVehicleAreKept) {
  FreeVehicle free;
  free.scene.state.bodies[0].v_WB = {1, 0.5, 0.3};
  SetAngularVelocity(free.vehicle.bodies[0], {0.3, 0.2, 0.1}, free.scene.state.bodies[0]);
  const Eigen::Vector3d before = free.Momentum();
  free.MeanEnergy(5);
  EXPECT_LT((free.Momentum() - before).norm(), 1e-8);
}

// Links, springs and joints, dampers too: internal forces. The half step between places and
// velocities changes nothing, v x v = 0.
TEST(Engine, AngularMomentumOfTheFreeVehicleIsKept) {
  for (const bool damped : {false, true}) {
    FreeVehicle free;
    if (damped) {
      free.vehicle.springs = Tm27().springs;
      free.vehicle.links = Tm27().links;
      free.vehicle.joints = Tm27().joints;
    }
    free.scene.state.bodies[0].v_WB = {1, 0.5, 0.3};
    SetAngularVelocity(free.vehicle.bodies[0], {0.3, 0.2, 0.1}, free.scene.state.bodies[0]);
    const Eigen::Vector3d before = free.AngularMomentum();
    EXPECT_GT(before.norm(), 100);
    free.MeanEnergy(5);
    EXPECT_LT((free.AngularMomentum() - before).norm(), 1e-8 * before.norm()) << damped;
  }
}

/// Place of a front wheel, relative to where it was, after 0.3 s of springing free.
Eigen::Vector3d PlaceAfterwards(double step) {
  FreeVehicle free;
  SetAngularVelocity(free.vehicle.bodies[0], {0.3, 0.2, 0.1}, free.scene.state.bodies[0]);
  free.StartWithStep(step);
  free.MeanEnergy(0.3);
  return ToEigen(free.scene.state.bodies[3].p_WB) - Eigen::Vector3d(0, 0, 1000);
}

TEST(Engine, UndampedMotionConvergesAtSecondOrder) {
  const Eigen::Vector3d exact = PlaceAfterwards(0.03125e-3);
  const double coarse = (PlaceAfterwards(0.5e-3) - exact).norm();
  const double middle = (PlaceAfterwards(0.25e-3) - exact).norm();
  const double fine = (PlaceAfterwards(0.125e-3) - exact).norm();
  RecordProperty("coarse_nm", static_cast<int>(1e9 * coarse));
  // Proportional to h^2 - 0.03125^2.
  EXPECT_NEAR(coarse / middle, 0.2490 / 0.0615, 0.3);
  EXPECT_NEAR(middle / fine, 0.0615 / 0.01465, 0.3);
}

TEST(Engine, InternalForcesHaveNoResultant) {
  FreeVehicle free;
  free.MeanEnergy(0.3);
  free.scene.Evaluate();
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < free.vehicle.bodies.size(); ++i) {
    const Eigen::Vector3d f = ToEigen(free.scene.work.wrench[i].f_W);
    force += f;
    moment +=
        ToEigen(free.scene.work.wrench[i].t_W) + ToEigen(free.scene.state.bodies[i].p_WB).cross(f);
  }
  EXPECT_LT(force.norm(), 1e-9);
  EXPECT_LT(moment.norm(), 1e-6);  // levers of 1000 m
}

TEST(Engine, DampersTakeTheEnergyAway) {
  FreeVehicle free;
  free.vehicle.springs = Tm27().springs;
  free.vehicle.links = Tm27().links;
  free.vehicle.joints = Tm27().joints;
  double last = free.MeanEnergy(1);
  for (int i = 0; i < 5; ++i) {
    const double next = free.MeanEnergy(1);
    EXPECT_LE(next, last * (1 + 1e-9));
    last = next;
  }
}

TEST(Engine, GroupsRunAtTheirOwnRates) {
  VehicleModel v = Tm27();
  v.steps = {1e-3, 3e-3, 6e-3, 12e-3};
  const EngineModel engine(v);
  EXPECT_EQ(engine.step, 1e-3);
  EXPECT_EQ(engine.spring_every, 3);
  EXPECT_EQ(engine.tire_every, 6);
  EXPECT_EQ(engine.control_every, 12);
}

TEST(Engine, ContactIsSampledAtTheTireRateOnly) {
  VehicleModel v = Tm27();
  v.steps = {2e-3, 2e-3, 4e-3, 4e-3};
  const auto ground = MakePlaneGround(0, 0);
  EngineScene scene(v, *ground);
  scene.Step();
  const Vec3<double> sampled = scene.state.wheels[0].contact.p_WH;
  scene.state.bodies[1].p_WB.x += 0.1;
  scene.Step();  // odd step: held
  EXPECT_EQ(scene.state.wheels[0].contact.p_WH.x, sampled.x);
  scene.Step();
  EXPECT_NE(scene.state.wheels[0].contact.p_WH.x, sampled.x);
}

}  // namespace
}  // namespace dbd
