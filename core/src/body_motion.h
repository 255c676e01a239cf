#pragma once

#include <dbd/core/units.h>

#include "engine_state.h"
#include "flatten.h"

namespace dbd {

// Motion of rigid bodies by central differences (paper eqs. 3-7): velocities live half a step
// before positions.
//
// Known difference: eq. 6 prints the rotational update with the mass, M/m; what eq. 2 asks for is
// the change of angular momentum, which is done here, with the gyroscopic effect of unequal moments
// of inertia included by turning the inertia with the body.

/// Angular velocity of a body with angular momentum h_W and attitude R_WB.
template <class Real, class Body>
Vec3<Real> AngularVelocity(const Body& body, const Mat3<Real>& R_WB, const Vec3<Real>& h_W) {
  const Vec3<Real> h_B = R_WB.TransposeTimes(h_W);
  return R_WB * Vec3<Real>{h_B.x * ToLanes<Real>(1 / body.inertia.x()),
                           h_B.y * ToLanes<Real>(1 / body.inertia.y()),
                           h_B.z * ToLanes<Real>(1 / body.inertia.z())};
}

/// Whether it turns about every axis alike.
inline bool IsSpherical(const Eigen::Vector3d& inertia) {
  return inertia.x() == inertia.y() && inertia.y() == inertia.z();
}

/// The angular velocity of the mid-step: the momentum belongs to t + dt/2, so the attitude must
/// too. One predictor with the attitude at t brings it there to second order.
template <class Real, class Body>
Vec3<Real> MidStepAngularVelocity(const Body& body, const Mat3<Real>& R_WB, const Quat<Real>& q_WB,
                                  const Vec3<Real>& h_W, const Real& dt) {
  using S = ScalarOf<Real>;
  if (IsSpherical(body.inertia)) return ToLanes<Real>(1 / body.inertia.x()) * h_W;
  const Vec3<Real> predicted = AngularVelocity(body, R_WB, h_W);
  const Quat<Real> q_mid = Turned(q_WB, Real(S(0.5)) * dt * predicted);
  return AngularVelocity(body, RotationMatrix(q_mid), h_W);
}

template <class Real, class Model>
DBD_STAGE void IntegrateBodies(const Model& model, double gravity, double step,
                               const Workspace<Real>& work, EngineState<Real>& state) {
  using S = ScalarOf<Real>;
  const Real dt{S(step)};
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto& body = model.bodies[i];
    const Wrench<Real>& wrench = work.wrench[i];
    BodyState<Real>& b = state.bodies[i];
    b.v_WB += ToLanes<Real>(step / body.mass) * wrench.f_W;
    b.v_WB.z = b.v_WB.z - ToLanes<Real>(gravity * step);
    b.h_WB += dt * wrench.t_W;
    b.w_WB = MidStepAngularVelocity(body, work.R_WB[i], b.q_WB, b.h_WB, dt);
    b.p_WB += dt * b.v_WB;
    b.q_WB = Rotated(b.q_WB, dt * b.w_WB);
  }
}

}  // namespace dbd
