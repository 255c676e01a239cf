#pragma once

#include <Eigen/Geometry>

#include "engine.h"
#include "initial_state.h"

namespace dbd {

inline Eigen::Vector3d ToEigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline Vec3<double> FromEigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Quat<double> FromEigen(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// One vehicle with everything that a step of the engine needs.
struct EngineScene {
  EngineScene(const VehicleModel& vehicle, const Ground& surface)
      : engine(vehicle),
        ground(surface),
        state(InitialState<double>(vehicle, surface, Eigen::Vector2d::Zero(), 0)),
        work(vehicle) {}

  void Evaluate() { EvaluateForces(engine, ground, controls, state, work); }
  void Step() { StepEngine(engine, ground, controls, state, work); }

  EngineModel engine;
  const Ground& ground;
  EngineState<double> state;
  Workspace<double> work;
  WheelControls<double> controls{};
};

/// Bodies alone: at rest, in their design places.
inline EngineState<double> StateOfBodies(const VehicleModel& vehicle) {
  EngineState<double> state;
  for (const BodyModel& body : vehicle.bodies) {
    BodyState<double> b{};
    b.p_WB = FromEigen(body.p_RB);
    b.q_WB = {1, 0, 0, 0};
    state.bodies.push_back(b);
  }
  return state;
}

/// Angular velocity and the momentum that belongs to it.
inline void SetAngularVelocity(const BodyModel& model, const Eigen::Vector3d& w_WB,
                               BodyState<double>& body) {
  const Mat3<double> R_WB = RotationMatrix(body.q_WB);
  const Eigen::Vector3d w_B = ToEigen(R_WB.TransposeTimes(FromEigen(w_WB)));
  body.w_WB = FromEigen(w_WB);
  body.h_WB = R_WB * FromEigen(model.inertia.cwiseProduct(w_B));
}

inline double KineticEnergy(const VehicleModel& vehicle, const EngineState<double>& state) {
  double energy = 0;
  for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
    const BodyState<double>& b = state.bodies[i];
    energy += 0.5 * vehicle.bodies[i].mass * Dot(b.v_WB, b.v_WB) + 0.5 * Dot(b.w_WB, b.h_WB);
  }
  return energy;
}

/// Energy stored in links, springs and joints, from their definitions, in Eigen's arithmetic.
inline double ElasticEnergy(const VehicleModel& vehicle, const EngineState<double>& state) {
  const auto rotation = [&](int body) {
    const Quat<double>& q = state.bodies[static_cast<std::size_t>(body)].q_WB;
    return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  };
  const auto point = [&](int body, const Eigen::Vector3d& p) {
    const Eigen::Vector3d origin = ToEigen(state.bodies[static_cast<std::size_t>(body)].p_WB);
    return Eigen::Vector3d(origin + rotation(body) * p);
  };
  const auto half_square = [](double k, double x) { return 0.5 * k * x * x; };
  double energy = 0;
  for (const LinkModel& link : vehicle.links) {
    const double length = (point(link.body_b, link.p_B) - point(link.body_a, link.p_A)).norm();
    energy += half_square(link.stiffness, length - link.free_length);
  }
  for (const SpringModel& s : vehicle.springs) {
    const Eigen::Vector3d lower =
        (1 - s.lever) * point(s.body_a, s.p_Q) + s.lever * point(s.body_b, s.p_B);
    energy += half_square(s.stiffness, (lower - point(s.body_a, s.p_A)).norm() - s.free_length);
  }
  for (const AxisJointModel& joint : vehicle.joints) {
    const Eigen::Vector3d a = rotation(joint.body_a) * joint.axis_a;
    const Eigen::Vector3d b = rotation(joint.body_b) * joint.axis_b;
    energy += half_square(joint.stiffness, a.dot(b) - joint.rest);
  }
  return energy;
}

}  // namespace dbd
