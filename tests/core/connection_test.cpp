#include <dbd/core/connection.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// A heavy body 0 and a body 1 of 20 kg.
VehicleModel TwoBodies(const Eigen::Vector3d& p_RB = {0.6, 0, 0.3}) {
  VehicleModel vehicle;
  vehicle.bodies.push_back({"base", 1e9, Eigen::Vector3d::Constant(1e9), {0, 0, 0}});
  vehicle.bodies.push_back({"arm", 20, {1.0, 1.2, 1.4}, p_RB});
  return vehicle;
}

Connection Joint(ConnectionKind kind, const Eigen::Vector3d& point) {
  Connection joint;
  joint.name = "joint";
  joint.kind = kind;
  joint.body_b = 1;
  joint.p_R = point;
  return joint;
}

void Evaluate(const VehicleModel& vehicle, EngineState<double>& state, Workspace<double>& work) {
  const WheelControls<double> controls{};
  for (std::size_t i = 0; i < 2; ++i) work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
  for (Wrench<double>& wrench : work.wrench) wrench.Clear();
  const EngineModel engine(vehicle);
  SetElementForces(engine, controls, state, work);
}

/// Stiffness of body 1 against body 0 held still, by central differences of its wrench.
Eigen::MatrixXd Stiffness(const VehicleModel& vehicle) {
  constexpr double kStep = 1e-6;
  Workspace<double> work(vehicle);
  Eigen::MatrixXd stiffness(6, 6);
  for (int axis = 0; axis < 6; ++axis) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(6);
    for (const double sign : {1.0, -1.0}) {
      EngineState<double> state = StateOfBodies(vehicle);
      Eigen::Vector3d d = Eigen::Vector3d::Zero();
      d[axis % 3] = sign * kStep;
      BodyState<double>& body = state.bodies[1];
      if (axis < 3) {
        body.p_WB += FromEigen(d);
      } else {
        body.q_WB = Rotated(body.q_WB, FromEigen(d));
      }
      Evaluate(vehicle, state, work);
      difference.head<3>() -= sign * ToEigen(work.wrench[1].f_W);
      difference.tail<3>() -= sign * ToEigen(work.wrench[1].t_W);
    }
    stiffness.col(axis) = difference / (2 * kStep);
  }
  return stiffness;
}

int SoftDegreesOfFreedom(ConnectionKind kind, const Eigen::Vector3d& point) {
  VehicleModel vehicle = TwoBodies();
  AddConnection(Joint(kind, point), vehicle);
  const Eigen::MatrixXd k = Stiffness(vehicle);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (k + k.transpose()));
  int soft = 0;
  for (const double value : solver.eigenvalues()) {
    EXPECT_GT(value, -1) << "unstable";
    if (value < 1) ++soft;  // the stiff ones are at least 5e5 * 0.1^2
  }
  return soft;
}

TEST(Connection, LeavesTheDegreesOfFreedomOfItsKind) {
  const Eigen::Vector3d center(0.6, 0, 0.3), beside(0, 0, 0.3);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kFree, center), 6);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kSpherical, center), 3);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kSpherical, beside), 3);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kRevolute, center), 1);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kRevolute, beside), 1);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kFixed, center), 0);
  EXPECT_EQ(SoftDegreesOfFreedom(ConnectionKind::kFixed, beside), 0);
}

/// Steps with gravity on body 1 alone: the base is too heavy to move but would fall.
void StepHung(const VehicleModel& vehicle, double dt, EngineState<double>& state,
              Workspace<double>& work) {
  Evaluate(vehicle, state, work);
  work.wrench[1].f_W.z -= vehicle.bodies[1].mass * kGravity;
  IntegrateBodies(vehicle, 0, dt, work, state);
  ++state.step;
}

TEST(Connection, PendulumOnARevoluteJointHasTheAnalyticPeriod) {
  VehicleModel vehicle = TwoBodies({0, 0, -0.6});
  vehicle.bodies[1].inertia = {1.0, 1.2, 1.4};
  AddConnection(Joint(ConnectionKind::kRevolute, {0, 0, 0}), vehicle);
  EngineState<double> state = StateOfBodies(vehicle);
  constexpr double kAngle = 0.05;  // [rad]
  BodyState<double>& body = state.bodies[1];
  body.q_WB = {std::cos(kAngle / 2), 0, std::sin(kAngle / 2), 0};
  body.p_WB = {-0.6 * std::sin(kAngle), 0, -0.6 * std::cos(kAngle)};
  Workspace<double> work(vehicle);
  constexpr double kStep = 5e-4;
  std::vector<double> crossings;
  double last = body.p_WB.x;
  for (int i = 0; i < 30000; ++i) {
    StepHung(vehicle, kStep, state, work);
    if (last < 0 && body.p_WB.x >= 0) crossings.push_back(i * kStep);
    last = body.p_WB.x;
  }
  // T = 2 pi sqrt((I + m l^2) / (m g l)) = 2 pi sqrt((1.2 + 7.2) / 117.68) = 1.6787 s
  const double expected = 2 * std::numbers::pi * std::sqrt(8.4 / (20 * kGravity * 0.6));
  ASSERT_GT(crossings.size(), 6u);
  const double period =
      (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  EXPECT_NEAR(period, expected, 0.01 * expected);
  EXPECT_NEAR(body.p_WB.y, 0, 1e-6);
}

TEST(Connection, FixedBodyCarriesItsWeightAndFollows) {
  VehicleModel vehicle = TwoBodies();
  AddConnection(Joint(ConnectionKind::kFixed, {0, 0, 0.3}), vehicle);
  EngineState<double> state = StateOfBodies(vehicle);
  // The base turns about z at 1 rad/s; the arm starts with it.
  SetAngularVelocity(vehicle.bodies[0], {0, 0, 1}, state.bodies[0]);
  SetAngularVelocity(vehicle.bodies[1], {0, 0, 1}, state.bodies[1]);
  state.bodies[1].v_WB = {0, 0.6, 0};
  Workspace<double> work(vehicle);
  for (int i = 0; i < 4000; ++i) StepHung(vehicle, 5e-4, state, work);
  const Vec3<double> x = RotationMatrix(state.bodies[0].q_WB).x;
  const Vec3<double> y = RotationMatrix(state.bodies[1].q_WB).y;
  EXPECT_NEAR(x.x, std::cos(2.0), 1e-3);
  EXPECT_NEAR(Dot(x, y), 0, 1e-3);
  // 196 N at 0.6 m on links of 5e5 N/m that are 0.2 m apart sags by some millimetres.
  const Eigen::Vector3d expected(0.6 * x.x, 0.6 * x.y, 0.3);
  EXPECT_LT((ToEigen(state.bodies[1].p_WB) - expected).norm(), 0.01);
}

TEST(Connection, RefusesWhatMakesNoSense) {
  const auto message = [](const auto& change) {
    VehicleModel vehicle = TwoBodies();
    Connection joint = Joint(ConnectionKind::kRevolute, {0, 0, 0});
    change(joint);
    return InputErrorOf([&] { AddConnection(joint, vehicle); });
  };
  EXPECT_EQ(message([](Connection& c) { c.body_b = 7; }),
            "connection \"joint\": its bodies must exist");
  EXPECT_EQ(message([](Connection& c) { c.body_b = 0; }),
            "connection \"joint\": needs two different bodies");
  EXPECT_EQ(message([](Connection& c) { c.axis.setZero(); }),
            "connection \"joint\": its axis must not be zero");
  EXPECT_EQ(message([](Connection& c) { c.base = 0; }),
            "connection \"joint\": base must be greater than 0");
}

}  // namespace
}  // namespace dbd
