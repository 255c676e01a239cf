#pragma once

#include "curve.h"
#include "engine_state.h"

namespace dbd {

// The force elements that join bodies: links, suspension springs and axis joints. Each adds equal
// and opposite forces to its two bodies.

/// A point fixed to a body: lever arm from the body's centre of mass, place and velocity in W.
template <class Real>
struct BodyPoint {
  Vec3<Real> lever;
  Vec3<Real> p;
  Vec3<Real> v;
};

template <class Real>
BodyPoint<Real> PointOn(const BodyState<Real>& body, const Mat3<Real>& R_WB,
                        const Eigen::Vector3d& p_BP) {
  const Vec3<Real> lever = R_WB * Broadcast<Real>(p_BP);
  return {lever, body.p_WB + lever, body.v_WB + Cross(body.w_WB, lever)};
}

/// Stiff spring-dampers in the place of arms and joints: F = k (L - L0) + c dL/dt, tension
/// positive (paper section 4.2).
template <class Real>
void AddLinkForces(const VehicleModel& model, const WheelControls<Real>& controls,
                   const EngineState<Real>& state, Workspace<Real>& work) {
  using S = ScalarOf<Real>;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const LinkModel& link = model.links[i];
    const auto a = PointOn(state.bodies[link.body_a], work.R_WB[link.body_a], link.p_A);
    const auto b = PointOn(state.bodies[link.body_b], work.R_WB[link.body_b], link.p_B);
    const Vec3<Real> d = b.p - a.p;
    const Real length = Norm(d);
    const Vec3<Real> direction = (Real(1) / length) * d;
    Real free_length{S(link.free_length)};
    if (link.steered_wheel >= 0) {
      const Real sine = controls.steer_sine[link.steered_wheel];
      free_length =
          free_length + sine * (Real(S(link.steer_linear)) + sine * Real(S(link.steer_quadratic)));
    }
    const Real tension = Real(S(link.stiffness)) * (length - free_length) +
                         Real(S(link.damping)) * Dot(b.v - a.v, direction);
    const Vec3<Real> f = tension * direction;
    work.wrench[link.body_a].Add(f, a.lever);
    work.wrench[link.body_b].Add(Real(-1) * f, b.lever);
    work.link_force[i] = tension;
  }
}

/// What the bump stops add to a spring's push; `rate`: of its length.
template <class Real>
Real StopForce(const BumpStopModel& stop, const Real& length, const Real& rate) {
  using S = ScalarOf<Real>;
  const Real zero(0);
  const auto push = [&](const Real& squeezed, const Real& squeezing) {
    const Real u = Max(squeezed, zero);
    const double bend = stop.progression > 0 ? 0.5 / stop.progression : 0;
    const Real elastic = Real(S(stop.stiffness)) * u * (Real(1) + Real(S(bend)) * u);
    return Clamp(elastic + Real(S(stop.damping)) * squeezing, zero, Real(2) * elastic);
  };
  return push(Real(S(stop.shortest_length)) - length, Real(-1) * rate) -
         push(length - Real(S(stop.longest_length)), rate);
}

/// Spring and damper along the strut, compression positive.
template <class Real>
Real StrutForce(const SpringModel& spring, const Real& length, const Real& rate) {
  using S = ScalarOf<Real>;
  const Real deflection = Real(S(spring.free_length)) - length;
  const Real elastic = spring.force_curve.given() ? EvaluateCurve(spring.force_curve, deflection)
                                                  : Real(S(spring.stiffness)) * deflection;
  const Real viscous = spring.damping_curve.given()
                           ? EvaluateCurve(spring.damping_curve, Real(-1) * rate)
                           : Real(S(-spring.damping)) * rate;
  if (spring.bump_stop.stiffness == 0) return elastic + viscous;
  return elastic + viscous + StopForce(spring.bump_stop, length, rate);
}

/// Suspension springs and shock absorbers, shared between pivot and wheel body by the lever.
template <class Real>
void AddSpringForces(const VehicleModel& model, const EngineState<Real>& state,
                     Workspace<Real>& work, std::vector<Wrench<Real>>& wrench) {
  using S = ScalarOf<Real>;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const SpringModel& spring = model.springs[i];
    const BodyState<Real>& body_a = state.bodies[spring.body_a];
    const Mat3<Real>& R_WA = work.R_WB[spring.body_a];
    const auto top = PointOn(body_a, R_WA, spring.p_A);
    const auto pivot = PointOn(body_a, R_WA, spring.p_Q);
    const auto ball = PointOn(state.bodies[spring.body_b], work.R_WB[spring.body_b], spring.p_B);
    const Real f(S(spring.lever)), g(S(1 - spring.lever));
    const Vec3<Real> d = g * pivot.p + f * ball.p - top.p;
    const Vec3<Real> rate = g * pivot.v + f * ball.v - top.v;
    const Real length = Norm(d);
    const Vec3<Real> direction = (Real(1) / length) * d;
    const Real push = StrutForce(spring, length, Dot(rate, direction));
    const Vec3<Real> force = push * direction;
    wrench[spring.body_a].Add(Real(-1) * force, top.lever);
    wrench[spring.body_a].Add(g * force, pivot.lever);
    wrench[spring.body_b].Add(f * force, ball.lever);
    work.spring_force[i] = push;
  }
}

/// Rotational constraints: with s = axis_a . axis_b and energy k (s - s0)^2 / 2 the torque on b is
/// k (s - s0) (a x b), and the damper's c ds/dt (a x b).
template <class Real>
void AddJointTorques(const VehicleModel& model, const WheelControls<Real>& controls,
                     const EngineState<Real>& state, Workspace<Real>& work) {
  using S = ScalarOf<Real>;
  for (const AxisJointModel& joint : model.joints) {
    const Vec3<Real> a = work.R_WB[joint.body_a] * Broadcast<Real>(joint.axis_a);
    const Vec3<Real> b = work.R_WB[joint.body_b] * Broadcast<Real>(joint.axis_b);
    const Vec3<Real> w_AB = state.bodies[joint.body_b].w_WB - state.bodies[joint.body_a].w_WB;
    const Vec3<Real> axis = Cross(a, b);
    Real target(S(joint.rest));
    if (joint.steered_wheel >= 0) target = target + controls.steer_sine[joint.steered_wheel];
    const Real rate = Real(-1) * Dot(w_AB, axis);
    const Real torque =
        Real(S(joint.stiffness)) * (Dot(a, b) - target) + Real(S(joint.damping)) * rate;
    const Vec3<Real> t = torque * axis;
    work.wrench[joint.body_b].t_W += t;
    work.wrench[joint.body_a].t_W -= t;
  }
}

}  // namespace dbd
