#pragma once

#include <dbd/core/simulation.h>

#include <cstring>

#include "initial_state.h"

namespace dbd {

// What drivers and observers see of an engine state, and what a driver's command means to it.

inline Eigen::Vector3d ToEigenVector(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

inline ChassisView ViewChassis(const BodyState<double>& body) {
  const Mat3<double> R_WB = RotationMatrix(body.q_WB);
  ChassisView view;
  view.p_WB = ToEigenVector(body.p_WB);
  view.q_WB = Eigen::Quaterniond(body.q_WB.w, body.q_WB.x, body.q_WB.y, body.q_WB.z);
  view.v_WB = ToEigenVector(body.v_WB);
  view.w_WB = ToEigenVector(body.w_WB);
  view.yaw = std::atan2(R_WB.x.y, R_WB.x.x);
  view.pitch = -std::asin(std::clamp(R_WB.x.z, -1.0, 1.0));
  view.roll = std::atan2(R_WB.y.z, R_WB.z.z);
  view.forward_speed = Dot(body.v_WB, R_WB.x);
  return view;
}

inline DriverView ViewForDriver(const VehicleModel& vehicle, const BodyState<double>& body) {
  const ChassisView chassis = ViewChassis(body);
  const Eigen::Vector3d rear = chassis.p_WB + chassis.q_WB * SteeringOrigin(vehicle);
  return {rear.head<2>(), chassis.yaw, chassis.forward_speed};
}

/// Steering and brakes.
inline void SetSteeringAndBrakes(const VehicleModel& vehicle, const DriverCommand& command,
                                 WheelControls<double>& controls) {
  AckermannSines(vehicle, command.steer, controls.steer_sine.data());
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.brake_torque[i] = command.brake * vehicle.wheels[i].brake_torque;
  }
}

/// The torque is shared evenly among driven wheels: open differentials; what locked and limited-
/// slip ones move across is found with the spins.
inline void SetControls(const VehicleModel& vehicle, const DriverCommand& command,
                        const EngineState<double>& state, double dt, PowertrainState& powertrain,
                        WheelControls<double>& controls) {
  SetSteeringAndBrakes(vehicle, command, controls);
  const auto driven = [&](std::size_t i) { return vehicle.axles[vehicle.wheels[i].axle].driven; };
  double spins = 0;
  int count = 0;
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (!driven(i)) continue;
    spins += state.wheels[i].spin;
    ++count;
  }
  if (count == 0) return;
  const double torque =
      UpdatePowertrain(vehicle.powertrain, command.engine_torque, spins / count, dt, powertrain);
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.drive_torque[i] = driven(i) ? torque / count : 0;
  }
}

/// FNV-1a over the whole state, bit by bit: bodies, wheels, contacts, frictions, powertrain.
inline std::uint64_t HashState(const EngineState<double>& state,
                               const PowertrainState& powertrain) {
  std::uint64_t hash = 1469598103934665603ull;
  const auto add = [&hash](const auto& plain) {
    unsigned char bytes[sizeof(plain)];
    std::memcpy(bytes, &plain, sizeof(plain));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ull;
  };
  for (const BodyState<double>& body : state.bodies) add(body);
  for (const WheelState<double>& wheel : state.wheels) add(wheel);
  for (const PointContactState<double>& contact : state.contacts) add(contact);
  for (const double friction : state.frictions) add(friction);
  add(powertrain.gear);
  add(powertrain.time_in_gear);
  add(powertrain.engine_torque);
  return hash;
}

/// Stretch of a stiff link at which it counts as torn [m].
inline constexpr double kTornLink = 0.2;

/// Everything finite, no link torn in the last step.
inline bool StateIsSane(const VehicleModel& vehicle, const EngineState<double>& state,
                        const Workspace<double>& work) {
  for (const BodyState<double>& body : state.bodies) {
    const double sum = body.p_WB.x + body.p_WB.y + body.p_WB.z + body.v_WB.x + body.v_WB.y +
                       body.v_WB.z + body.q_WB.w + body.w_WB.x + body.w_WB.y + body.w_WB.z;
    if (!std::isfinite(sum)) return false;
  }
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const double most = kTornLink * vehicle.links[i].stiffness;
    if (!(std::abs(work.link_force[i]) < most)) return false;
  }
  return true;
}

}  // namespace dbd
