#include "elements.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// Two bodies of the same kind, apart, turned and moving, to be joined by one element.
class TwoBodies : public ::testing::Test {
 protected:
  TwoBodies() {
    vehicle.bodies.push_back({"a", 5, Eigen::Vector3d(1, 2, 3), {0, 0, 0}});
    vehicle.bodies.push_back({"b", 3, Eigen::Vector3d(2, 1, 2), {1, 0.5, 0.2}});
    state = StateOfBodies(vehicle);
    Turn(0, {0.2, -0.1, 0.4});
    Turn(1, {-0.3, 0.5, 0.1});
  }

  void Turn(std::size_t body, const Eigen::Vector3d& r) {
    state.bodies[body].q_WB = Rotated(state.bodies[body].q_WB, FromEigen(r));
  }

  void Move() {
    state.bodies[0].v_WB = {0.3, -0.2, 0.1};
    state.bodies[1].v_WB = {-0.4, 0.5, 0.2};
    SetAngularVelocity(vehicle.bodies[0], {0.7, -0.3, 0.2}, state.bodies[0]);
    SetAngularVelocity(vehicle.bodies[1], {-0.2, 0.9, 0.4}, state.bodies[1]);
  }

  std::vector<Wrench<double>> Forces() {
    Workspace<double> work(vehicle);
    for (std::size_t i = 0; i < 2; ++i) work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
    SetElementForces(EngineModel(vehicle), WheelControls<double>{}, state, work);
    link_force = work.link_force;
    return work.wrench;
  }

  /// Sum of forces, and of moments about the origin of W.
  void ExpectThirdLaw() {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
    const auto wrench = Forces();
    for (std::size_t i = 0; i < 2; ++i) {
      force += ToEigen(wrench[i].f_W);
      moment +=
          ToEigen(wrench[i].t_W) + ToEigen(state.bodies[i].p_WB).cross(ToEigen(wrench[i].f_W));
    }
    EXPECT_LT(force.norm(), 1e-9);
    EXPECT_LT(moment.norm(), 1e-9);
  }

  double Energy() const { return ElasticEnergy(vehicle, state); }

  /// Forces at rest against -dE/dx, by central differences of 1e-6 m or rad.
  void ExpectGradient() {
    const auto wrench = Forces();
    const double h = 1e-6;
    for (std::size_t body = 0; body < 2; ++body) {
      for (int axis = 0; axis < 3; ++axis) {
        const EngineState<double> rest = state;
        const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
        const auto difference = [&](const std::function<void(double)>& change) {
          change(h);
          const double plus = Energy();
          state = rest;
          change(-h);
          const double minus = Energy();
          state = rest;
          return (plus - minus) / (2 * h);
        };
        const double force =
            -difference([&](double s) { state.bodies[body].p_WB += FromEigen(s * unit); });
        const double torque = -difference([&](double s) { Turn(body, s * unit); });
        EXPECT_NEAR(ToEigen(wrench[body].f_W)[axis], force, 1e-3) << body << axis;
        EXPECT_NEAR(ToEigen(wrench[body].t_W)[axis], torque, 1e-3) << body << axis;
      }
    }
  }

  /// Power of all forces when the elements store nothing.
  double Power() {
    double power = 0;
    const auto wrench = Forces();
    for (std::size_t i = 0; i < 2; ++i) {
      power += Dot(wrench[i].f_W, state.bodies[i].v_WB) + Dot(wrench[i].t_W, state.bodies[i].w_WB);
    }
    return power;
  }

  void AddLink(double stiffness, double damping, const Eigen::Vector3d& p_A = {0.1, 0.2, -0.1},
               const Eigen::Vector3d& p_B = {-0.2, 0.1, 0.1}) {
    LinkModel link;
    link.body_b = 1;
    link.p_A = p_A, link.p_B = p_B;
    link.stiffness = stiffness, link.damping = damping;
    link.free_length = 0.9;
    vehicle.links.push_back(link);
  }
  void AddSpring(double lever, double stiffness, double damping) {
    SpringModel spring;
    spring.body_b = 1;
    spring.p_A = {0.1, 0.1, 0.8}, spring.p_Q = {0.2, 0, -0.1}, spring.p_B = {-0.1, -0.2, 0};
    spring.lever = lever;
    spring.stiffness = stiffness, spring.damping = damping;
    spring.free_length = 0.7;
    vehicle.springs.push_back(spring);
  }
  void AddJoint(double stiffness, double damping) {
    AxisJointModel joint;
    joint.body_b = 1;
    joint.stiffness = stiffness, joint.damping = damping;
    joint.rest = 0.1;
    vehicle.joints.push_back(joint);
  }

  VehicleModel vehicle;
  EngineState<double> state;
  std::vector<double> link_force;
};

TEST_F(TwoBodies, LinkForceByHand) {
  state = StateOfBodies(vehicle);
  state.bodies[1].p_WB = {1.2, 0, 0};
  state.bodies[1].v_WB = {0.5, 3, 0};
  AddLink(1000, 20, {0.1, 0, 0}, {-0.1, 0, 0});
  // Length 1.2 - 0.2 = 1.0, stretched by 0.1 m at 0.5 m/s: 1000 * 0.1 + 20 * 0.5 = 110 N tension,
  // which pulls a forward and b back along the line through both centres.
  const auto wrench = Forces();
  EXPECT_NEAR(link_force[0], 110, 1e-9);
  EXPECT_NEAR(wrench[0].f_W.x, 110, 1e-9);
  EXPECT_NEAR(wrench[1].f_W.x, -110, 1e-9);
  EXPECT_NEAR(ToEigen(wrench[0].t_W).norm() + ToEigen(wrench[1].t_W).norm(), 0, 1e-9);
}

TEST_F(TwoBodies, LinkMomentIsLeverTimesForce) {
  state = StateOfBodies(vehicle);
  state.bodies[1].p_WB = {1, 0, 0};
  AddLink(1000, 0, {0, 0, 0.5}, {0, 0, 0.5});
  // 100 N of tension along x at a height of 0.5 m: moment (0, 0.5 * 100, 0) on a, less on b.
  const auto wrench = Forces();
  EXPECT_NEAR(wrench[0].t_W.y, 50, 1e-9);
  EXPECT_NEAR(wrench[1].t_W.y, -50, 1e-9);
}

TEST_F(TwoBodies, SpringIsSharedByTheLever) {
  AddSpring(0.3, 2e4, 0);
  state = StateOfBodies(vehicle);
  const auto wrench = Forces();
  // The carrier takes f = 0.3 of the force, the chassis' pivot the rest, its mount all of it.
  const Eigen::Vector3d top(0.1, 0.1, 0.8), pivot(0.2, 0, -0.1), ball(0.9, 0.3, 0.2);
  const Eigen::Vector3d d = 0.7 * pivot + 0.3 * ball - top;
  const Eigen::Vector3d push = 2e4 * (0.7 - d.norm()) * d.normalized();
  EXPECT_LT((ToEigen(wrench[1].f_W) - 0.3 * push).norm(), 1e-8);
  EXPECT_LT((ToEigen(wrench[0].f_W) + push - 0.7 * push).norm(), 1e-8);
  EXPECT_LT((ToEigen(wrench[0].t_W) + top.cross(push) - 0.7 * pivot.cross(push)).norm(), 1e-8);
}

TEST_F(TwoBodies, ThirdLawForEveryElement) {
  Move();
  AddLink(5e4, 300);
  ExpectThirdLaw();
  AddSpring(0.4, 2e4, 400);
  ExpectThirdLaw();
  AddJoint(3e3, 20);
  ExpectThirdLaw();
}

TEST_F(TwoBodies, LinkForceIsTheGradientOfItsEnergy) {
  AddLink(5e4, 300);
  ExpectGradient();
}

TEST_F(TwoBodies, SpringForceIsTheGradientOfItsEnergy) {
  AddSpring(0.4, 2e4, 400);
  ExpectGradient();
}

TEST_F(TwoBodies, JointTorqueIsTheGradientOfItsEnergy) {
  AddJoint(3e3, 20);
  ExpectGradient();
}

TEST_F(TwoBodies, DampersOnlyTakeEnergy) {
  AddLink(0, 300);
  AddSpring(0.4, 0, 400);
  AddJoint(0, 20);
  for (int i = 0; i < 20; ++i) {
    Move();
    const double a = 0.7 * i;
    state.bodies[0].v_WB = {std::cos(a), std::sin(2 * a), std::cos(3 * a)};
    SetAngularVelocity(vehicle.bodies[1], {std::sin(a), std::cos(5 * a), 1}, state.bodies[1]);
    EXPECT_LE(Power(), 0) << i;
  }
}

TEST_F(TwoBodies, MotionTogetherAsOneRigidBodyIsNotDamped) {
  AddLink(0, 300);
  AddSpring(0.4, 0, 400);
  AddJoint(0, 20);
  const Eigen::Vector3d w(0.4, -0.7, 0.9);
  for (std::size_t i = 0; i < 2; ++i) {
    state.bodies[i].v_WB = FromEigen(w.cross(ToEigen(state.bodies[i].p_WB)));
    SetAngularVelocity(vehicle.bodies[i], w, state.bodies[i]);
  }
  for (const Wrench<double>& wrench : Forces()) {
    EXPECT_LT(ToEigen(wrench.f_W).norm() + ToEigen(wrench.t_W).norm(), 1e-10);
  }
}

TEST_F(TwoBodies, SteeringMovesTheJointsTarget) {
  AddJoint(3e3, 0);
  state = StateOfBodies(vehicle);
  vehicle.joints[0].steered_wheel = 2;
  vehicle.joints[0].rest = 0;
  Workspace<double> work(vehicle);
  for (std::size_t i = 0; i < 2; ++i) work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
  WheelControls<double> controls{};
  controls.steer_sine[2] = 0.1;
  SetElementForces(EngineModel(vehicle), controls, state, work);
  // y . x = 0, target 0.1: torque 3000 * (0 - 0.1) along y cross x = -z turns b to the left.
  EXPECT_NEAR(work.wrench[1].t_W.z, 300, 1e-9);
  EXPECT_NEAR(work.wrench[0].t_W.z, -300, 1e-9);
}

}  // namespace
}  // namespace dbd
