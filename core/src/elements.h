#pragma once

#include "attachment_points.h"
#include "curve.h"
#include "engine_state.h"

namespace dbd {

// The force elements that join bodies: links, suspension springs and axis joints. Each adds equal
// and opposite forces to its two bodies.

template <class Real, class Vector>
BodyPoint<Real> PointOn(const BodyState<Real>& body, const Mat3<Real>& R_WB, const Vector& p_BP) {
  const Vec3<Real> lever = R_WB * Broadcast<Real>(p_BP);
  return {lever, body.p_WB + lever, body.v_WB + Cross(body.w_WB, lever)};
}

/// Brings the attachment points to the present pose and motion of their bodies.
template <class Real, class Attachments>
void MovePoints(const Attachments& attachments, const EngineState<Real>& state,
                Workspace<Real>& work) {
  const auto& points = attachments.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int body = points[i].body;
    work.points[i] = PointOn(state.bodies[body], work.R_WB[body], points[i].p_B);
  }
}

/// Stiff spring-dampers in the place of arms and joints: F = k (L - L0) + c dL/dt, tension
/// positive (paper section 4.2).
template <class Real, class Model, class Attachments>
void AddLinkForces(const Model& model, const Attachments& attachments,
                   const WheelControls<Real>& controls, Workspace<Real>& work) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& link = model.links[i];
    const auto ends = attachments.links()[i];
    const BodyPoint<Real>&a = work.points[ends.a], &b = work.points[ends.b];
    const Vec3<Real> d = b.p - a.p;
    const Real length = Norm(d);
    const Vec3<Real> direction = (Real(1) / length) * d;
    Real free_length = ToLanes<Real>(link.free_length);
    if (link.steered_wheel >= 0) {
      const Real sine = controls.steer_sine[link.steered_wheel];
      free_length = free_length + sine * (ToLanes<Real>(link.steer_linear) +
                                          sine * ToLanes<Real>(link.steer_quadratic));
    }
    const Real tension = ToLanes<Real>(link.stiffness) * (length - free_length) +
                         ToLanes<Real>(link.damping) * Dot(b.v - a.v, direction);
    const Vec3<Real> f = tension * direction;
    work.point_force[ends.a] += f;
    work.point_force[ends.b] -= f;
    work.link_force[i] = tension;
  }
}

/// By how much a stop's stiffness grows per compression, of its stiffness at first contact [1/m].
inline double StiffnessGrowth(const BumpStopModel& stop) {
  return stop.progression > 0 ? 0.5 / stop.progression : 0;
}

inline bool HasStops(const SpringModel& spring) { return spring.bump_stop.stiffness != 0; }

/// What the bump stops add to a spring's push; `rate`: of its length.
template <class Real, class BumpStop>
Real StopForce(const BumpStop& stop, const Real& length, const Real& rate) {
  const Real zero(0);
  const auto push = [&](const Real& squeezed, const Real& squeezing) {
    const Real u = Max(squeezed, zero);
    const Real elastic =
        ToLanes<Real>(stop.stiffness) * u * (Real(1) + ToLanes<Real>(StiffnessGrowth(stop)) * u);
    return Clamp(elastic + ToLanes<Real>(stop.damping) * squeezing, zero, Real(2) * elastic);
  };
  return push(ToLanes<Real>(stop.shortest_length) - length, Real(-1) * rate) -
         push(length - ToLanes<Real>(stop.longest_length), rate);
}

/// Spring and damper along the strut, compression positive.
template <class Real, class Spring>
Real StrutForce(const Spring& spring, const Real& length, const Real& rate) {
  const Real deflection = ToLanes<Real>(spring.free_length) - length;
  const Real elastic = spring.force_curve.given() ? EvaluateCurve(spring.force_curve, deflection)
                                                  : ToLanes<Real>(spring.stiffness) * deflection;
  const Real viscous = spring.damping_curve.given()
                           ? EvaluateCurve(spring.damping_curve, Real(-1) * rate)
                           : ToLanes<Real>(-spring.damping) * rate;
  if (!HasStops(spring)) return elastic + viscous;
  return elastic + viscous + StopForce(spring.bump_stop, length, rate);
}

/// Suspension springs and shock absorbers: the push of each at the present time, to be held.
template <class Real, class Model, class Attachments>
void UpdateSprings(const Model& model, const Attachments& attachments, Workspace<Real>& work) {
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const auto& spring = model.springs[i];
    const auto ends = attachments.springs()[i];
    const BodyPoint<Real>&top = work.points[ends.top], &pivot = work.points[ends.pivot],
          &ball = work.points[ends.ball];
    const Real f = ToLanes<Real>(spring.lever), g = ToLanes<Real>(1 - spring.lever);
    const Vec3<Real> d = g * pivot.p + f * ball.p - top.p;
    const Vec3<Real> rate = g * pivot.v + f * ball.v - top.v;
    const Real length = Norm(d);
    const Vec3<Real> direction = (Real(1) / length) * d;
    work.spring_force[i] = StrutForce(spring, length, Dot(rate, direction));
    work.spring_push_W[i] = work.spring_force[i] * direction;
  }
}

/// The held pushes, shared between pivot and wheel body by the lever.
template <class Real, class Model, class Attachments>
void AddSpringForces(const Model& model, const Attachments& attachments, Workspace<Real>& work) {
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const auto ends = attachments.springs()[i];
    const Vec3<Real> push = work.spring_push_W[i];
    work.point_force[ends.top] -= push;
    work.point_force[ends.pivot] += ToLanes<Real>(1 - model.springs[i].lever) * push;
    work.point_force[ends.ball] += ToLanes<Real>(model.springs[i].lever) * push;
  }
}

/// Sums the forces on each body's points into its wrench, which begins anew.
template <class Real, class Attachments>
void GatherPointForces(const Attachments& attachments, Workspace<Real>& work) {
  for (std::size_t body = 0; body < work.wrench.size(); ++body) {
    Wrench<Real> sum{};
    for (std::size_t i = attachments.first()[body]; i < attachments.first()[body + 1]; ++i) {
      sum.Add(work.point_force[i], work.points[i].lever);
    }
    work.wrench[body] = sum;
  }
}

/// Rotational constraints: with s = axis_a . axis_b and energy k (s - s0)^2 / 2 the torque on b is
/// k (s - s0) (a x b), and the damper's c ds/dt (a x b).
template <class Real, class Model>
void AddJointTorques(const Model& model, const WheelControls<Real>& controls,
                     const EngineState<Real>& state, Workspace<Real>& work) {
  for (const auto& joint : model.joints) {
    const Vec3<Real> a = work.R_WB[joint.body_a] * Broadcast<Real>(joint.axis_a);
    const Vec3<Real> b = work.R_WB[joint.body_b] * Broadcast<Real>(joint.axis_b);
    const Vec3<Real> w_AB = state.bodies[joint.body_b].w_WB - state.bodies[joint.body_a].w_WB;
    const Vec3<Real> axis = Cross(a, b);
    Real target = ToLanes<Real>(joint.rest);
    if (joint.steered_wheel >= 0) target = target + controls.steer_sine[joint.steered_wheel];
    const Real rate = Real(-1) * Dot(w_AB, axis);
    const Real torque =
        ToLanes<Real>(joint.stiffness) * (Dot(a, b) - target) + ToLanes<Real>(joint.damping) * rate;
    const Vec3<Real> t = torque * axis;
    work.wrench[joint.body_b].t_W += t;
    work.wrench[joint.body_a].t_W -= t;
  }
}

}  // namespace dbd
