#pragma once

#include "curve.h"
#include "engine_state.h"
#include "flatten.h"
#include "joined_bodies.h"

namespace dbd {

// The force elements that join bodies: links, suspension springs and axis joints. Those between
// bodies a and b are evaluated as a sees them: in a's axes the points of a are constants at rest.
// Each element's force acts along a line through its ends, or is a couple, so that what it does to
// a is opposite to what it does to b as a whole: force and moment on b are summed, and a gets them
// once for all elements.

template <class Real, class Vector>
BodyPoint<Real> PointOn(const BodyState<Real>& body, const Mat3<Real>& R_WB, const Vector& p_BP) {
  const Vec3<Real> lever = R_WB * Broadcast<Real>(p_BP);
  return {lever, body.p_WB + lever, body.v_WB + Cross(body.w_WB, lever)};
}

/// Pose and motion of body b in the axes of body a, which is at rest there.
template <class Real>
struct RelativeMotion {
  Mat3<Real> R_AB;
  Vec3<Real> p_AB;
  Vec3<Real> v_AB;  // of Bo, as a sees it
  Vec3<Real> w_AB;
};

template <class Real>
RelativeMotion<Real> MotionSeenFrom(const BodyState<Real>& a, const Mat3<Real>& R_WA,
                                    const BodyState<Real>& b, const Mat3<Real>& R_WB) {
  const Vec3<Real> d_W = b.p_WB - a.p_WB;
  return {{R_WA.TransposeTimes(R_WB.x), R_WA.TransposeTimes(R_WB.y), R_WA.TransposeTimes(R_WB.z)},
          R_WA.TransposeTimes(d_W),
          R_WA.TransposeTimes(b.v_WB - a.v_WB - Cross(a.w_WB, d_W)),
          R_WA.TransposeTimes(b.w_WB - a.w_WB)};
}

/// A point of body b at which elements pull: lever from Bo, place and velocity, in axes of a.
template <class Real, class Model>
BodyPoint<Real> PlaceBall(const Model& model, const JoinedBodies::Ball& ball,
                          const RelativeMotion<Real>& motion) {
  const auto& p_B =
      ball.of_link >= 0 ? model.links[ball.of_link].p_B : model.springs[ball.of_spring].p_B;
  const Vec3<Real> lever = motion.R_AB * Broadcast<Real>(p_B);
  return {lever, motion.p_AB + lever, motion.v_AB + Cross(motion.w_AB, lever)};
}

/// Free length of a link: a tie rod's follows the steering.
template <class Real, class Link>
Real FreeLength(const Link& link, const WheelControls<Real>& controls) {
  const Real free_length = ToLanes<Real>(link.free_length);
  if (link.steered_wheel < 0) return free_length;
  const Real sine = controls.steer_sine[link.steered_wheel];
  return free_length +
         sine * (ToLanes<Real>(link.steer_linear) + sine * ToLanes<Real>(link.steer_quadratic));
}

/// Stiff spring-damper in the place of an arm or a joint: F = k (L - L0) + c dL/dt, tension
/// positive (paper section 4.2). Returns the force on body b.
template <class Real, class Link>
Vec3<Real> LinkForce(const Link& link, const WheelControls<Real>& controls,
                     const BodyPoint<Real>& ball, Real& tension) {
  const Vec3<Real> d = ball.p - Broadcast<Real>(link.p_A);
  const Real length = Norm(d);
  const Vec3<Real> direction = (Real(1) / length) * d;
  tension = ToLanes<Real>(link.stiffness) * (length - FreeLength(link, controls)) +
            ToLanes<Real>(link.damping) * Dot(ball.v, direction);
  return (Real(-1) * tension) * direction;
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
    return Clamp(elastic + ToLanes<Real>(stop.damping) * squeezing, zero, elastic + elastic);
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
                           ? EvaluateCurve<Real>(spring.damping_curve, Real(-1) * rate)
                           : ToLanes<Real>(-spring.damping) * rate;
  if (!HasStops(spring)) return elastic + viscous;
  return elastic + viscous + StopForce(spring.bump_stop, length, rate);
}

/// Push of a suspension spring and shock absorber at its lower mount, which lies between the pivot
/// on a and the ball on b.
template <class Real, class Spring>
Vec3<Real> SpringPush(const Spring& spring, const BodyPoint<Real>& ball, Real& force) {
  const Real f = ToLanes<Real>(spring.lever), g = ToLanes<Real>(1 - spring.lever);
  const Vec3<Real> d = f * ball.p + (g * Broadcast<Real>(spring.p_Q) - Broadcast<Real>(spring.p_A));
  const Real length = Norm(d);
  const Vec3<Real> direction = (Real(1) / length) * d;
  const Real rate = f * Dot(ball.v, direction);
  force = StrutForce(spring, length, rate);
  return force * direction;
}

/// Rotational constraint: with s = axis_a . axis_b and energy k (s - s0)^2 / 2 the torque on b is
/// k (s - s0) (a x b), and the damper's c ds/dt (a x b).
template <class Real, class Joint>
Vec3<Real> JointTorque(const Joint& joint, const WheelControls<Real>& controls,
                       const RelativeMotion<Real>& motion) {
  const Vec3<Real> a = Broadcast<Real>(joint.axis_a);
  const Vec3<Real> b = motion.R_AB * Broadcast<Real>(joint.axis_b);
  const Vec3<Real> axis = Cross(a, b);
  Real target = ToLanes<Real>(joint.rest);
  if (joint.steered_wheel >= 0) target = target + controls.steer_sine[joint.steered_wheel];
  const Real rate = Real(-1) * Dot(motion.w_AB, axis);
  const Real torque =
      ToLanes<Real>(joint.stiffness) * (Dot(a, b) - target) + ToLanes<Real>(joint.damping) * rate;
  return torque * axis;
}

/// Sum of the forces on body b at one ball. Of a spring's push b takes the share of its lever, the
/// pivot on a the rest.
template <class Real, class Model>
Vec3<Real> BallForce(const Model& model, const JoinedBodies& joined, const JoinedBodies::Ball& ball,
                     const WheelControls<Real>& controls, bool update_springs,
                     const BodyPoint<Real>& place, Workspace<Real>& work) {
  Vec3<Real> sum{};
  for (int i = ball.links.begin; i < ball.links.end; ++i) {
    const int link = joined.links[i];
    sum += LinkForce(model.links[link], controls, place, work.link_force[link]);
  }
  for (int i = ball.springs.begin; i < ball.springs.end; ++i) {
    const int spring = joined.springs[i];
    Vec3<Real>& push = work.spring_push[spring];
    if (update_springs) push = SpringPush(model.springs[spring], place, work.spring_force[spring]);
    sum += ToLanes<Real>(model.springs[spring].lever) * push;
  }
  return sum;
}

/// Force on body b and its moment about Bo, in axes of a.
template <class Real>
struct JoiningWrench {
  Vec3<Real> f_A, t_A;
};

template <class Real, class Model>
JoiningWrench<Real> SumJoiningForces(const Model& model, const JoinedBodies& joined,
                                     const JoinedBodies::Pair& pair,
                                     const WheelControls<Real>& controls, bool update_springs,
                                     const RelativeMotion<Real>& motion, Workspace<Real>& work) {
  JoiningWrench<Real> on_b{};
  for (int i = pair.balls.begin; i < pair.balls.end; ++i) {
    const JoinedBodies::Ball& ball = joined.balls[i];
    const BodyPoint<Real> place = PlaceBall(model, ball, motion);
    const Vec3<Real> f_A = BallForce(model, joined, ball, controls, update_springs, place, work);
    on_b.f_A += f_A;
    on_b.t_A += Cross(place.lever, f_A);
  }
  for (int i = pair.joints.begin; i < pair.joints.end; ++i) {
    on_b.t_A += JointTorque(model.joints[joined.joints[i]], controls, motion);
  }
  return on_b;
}

/// All of the above into work.wrench, which begins anew. Springs are held between their updates,
/// in axes of their body a.
template <class Real, class Model>
DBD_STAGE void SetJoiningForces(const Model& model, const JoinedBodies& joined,
                                const WheelControls<Real>& controls, bool update_springs,
                                const EngineState<Real>& state, Workspace<Real>& work) {
  for (Wrench<Real>& wrench : work.wrench) wrench.Clear();
  for (const JoinedBodies::Pair& pair : joined.pairs) {
    const BodyState<Real>&a = state.bodies[pair.body_a], &b = state.bodies[pair.body_b];
    const Mat3<Real>& R_WA = work.R_WB[pair.body_a];
    const auto motion = MotionSeenFrom(a, R_WA, b, work.R_WB[pair.body_b]);
    const JoiningWrench<Real> on_b =
        SumJoiningForces(model, joined, pair, controls, update_springs, motion, work);
    const Vec3<Real> f_W = R_WA * on_b.f_A, t_W = R_WA * on_b.t_A;
    work.wrench[pair.body_b].f_W += f_W;
    work.wrench[pair.body_b].t_W += t_W;
    work.wrench[pair.body_a].f_W -= f_W;
    work.wrench[pair.body_a].t_W -= t_W + Cross(b.p_WB - a.p_WB, f_W);
  }
}

}  // namespace dbd
