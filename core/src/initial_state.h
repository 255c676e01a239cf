#pragma once

#include <dbd/core/ground.h>

#include <Eigen/Dense>

#include "body_motion.h"
#include "engine_state.h"

namespace dbd {

/// Rate at which settling takes motion away [1/s]: about critical for a 2 Hz suspension.
inline constexpr double kSettlingRate = 15.0;

/// The point that follows a path, at the height of the reference frame, in the chassis frame.
inline Eigen::Vector3d SteeringOrigin(const VehicleModel& vehicle) {
  return Eigen::Vector3d(vehicle.path_point_x(), 0, 0) - vehicle.bodies[0].p_RB;
}

/// Least-squares plane z = a + b x + c y through the ground under the wheels, as the attitude that
/// has this plane's normal and the given heading.
inline Eigen::Quaterniond AttitudeOnGround(const VehicleModel& vehicle, const Ground& ground,
                                           const Eigen::Vector2d& origin, double heading,
                                           double* height) {
  const Eigen::Rotation2Dd turn(heading);
  const Eigen::Vector2d p_RO = (SteeringOrigin(vehicle) + vehicle.bodies[0].p_RB).head<2>();
  const auto n = static_cast<Eigen::Index>(vehicle.wheels.size());
  Eigen::MatrixXd places(n, 3);
  Eigen::VectorXd heights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WheelModel& wheel = vehicle.wheels[static_cast<std::size_t>(i)];
    const Eigen::Vector3d hub = vehicle.bodies[wheel.body].p_RB + wheel.p_BH;
    const Eigen::Vector2d offset = turn * (hub.head<2>() - p_RO);
    places.row(i) << 1, offset.x(), offset.y();
    heights(i) = ground.Height(origin.x() + offset.x(), origin.y() + offset.y());
  }
  const Eigen::Vector3d plane = places.completeOrthogonalDecomposition().solve(heights);
  *height = plane(0);
  const Eigen::Vector3d up = Eigen::Vector3d(-plane(1), -plane(2), 1).normalized();
  const Eigen::Vector2d course(std::cos(heading), std::sin(heading));
  Eigen::Matrix3d R;
  R.col(0) = Eigen::Vector3d(course.x(), course.y(), plane.tail<2>().dot(course)).normalized();
  R.col(1) = up.cross(R.col(0));
  R.col(2) = up;
  return Eigen::Quaterniond(R);
}

/// The design pose stood on the ground at rest, with the steering origin over `position`.
template <class Real>
EngineState<Real> InitialState(const VehicleModel& vehicle, const Ground& ground,
                               const Eigen::Vector2d& position, double heading) {
  double height = 0;
  const Eigen::Quaterniond q = AttitudeOnGround(vehicle, ground, position, heading, &height);
  const Eigen::Vector3d p_RO = SteeringOrigin(vehicle) + vehicle.bodies[0].p_RB;
  // The steering origin's foot on the plane stands reference_height below it along the normal.
  const Eigen::Vector3d foot(position.x(), position.y(), height);
  const Eigen::Vector3d p_WR = foot + q * (Eigen::Vector3d(0, 0, vehicle.reference_height) -
                                           Eigen::Vector3d(p_RO.x(), p_RO.y(), 0));
  EngineState<Real> state;
  for (const BodyModel& body : vehicle.bodies) {
    using S = ScalarOf<Real>;
    BodyState<Real> b{};
    b.p_WB = Broadcast<Real>(p_WR + q * body.p_RB);
    b.q_WB = {Real(S(q.w())), Real(S(q.x())), Real(S(q.y())), Real(S(q.z()))};
    state.bodies.push_back(b);
  }
  state.contacts.assign(vehicle.contacts.size(), {});
  state.frictions.assign(vehicle.frictions.size(), Real(0));
  state.wheels.resize(vehicle.wheels.size());
  for (WheelState<Real>& wheel : state.wheels) {
    wheel = {};
    wheel.contact.normal_W.z = Real(1);
  }
  return state;
}

/// Leaves the share `keep` of all velocities.
template <class Real>
void DampMotion(const Real& keep, EngineState<Real>& state) {
  for (BodyState<Real>& body : state.bodies) {
    body.v_WB = keep * body.v_WB;
    body.h_WB = keep * body.h_WB;
    body.w_WB = keep * body.w_WB;
  }
}

}  // namespace dbd
