#pragma once

#include <dbd/core/ground.h>

#include <array>

#include "elements.h"
#include "flatten.h"

namespace dbd {

// Contact of body points with the ground, dry friction between bodies, and applied loads.
//
// Both frictions are bristles: an elastic displacement that follows the motion and yields where its
// force would exceed the limit. Known difference from Coulomb's law: a few micrometres of elastic
// give before slip; in exchange a body at rest stays at rest, and no step size makes it chatter
// below the bristle's own frequency.

/// Height and normal of the ground under `p`, from heights before, behind, left and right of it as
/// the body points: the result depends neither on the heading nor on the side.
template <class Real, class Surface>
void SampleTangentPlane(const Surface& ground, const Mat3<Real>& R_WB, const Vec3<Real>& p,
                        PointContactState<Real>& contact) {
  using S = ScalarOf<Real>;
  constexpr double kReach = 0.025;  // [m] to each side
  constexpr std::array<std::array<double, 2>, 5> kPlaces = {
      {{0, 0}, {kReach, 0}, {-kReach, 0}, {0, kReach}, {0, -kReach}}};
  const Vec3<Real> ahead = Normalized(Vec3<Real>{R_WB.x.x, R_WB.x.y, Real(0)});  // left: (-y, x)
  Real x[5], y[5], z[5];
  for (int j = 0; j < 5; ++j) {
    const Real along{S(kPlaces[j][0])}, left{S(kPlaces[j][1])};
    x[j] = p.x + along * ahead.x - left * ahead.y;
    y[j] = p.y + along * ahead.y + left * ahead.x;
  }
  ground.Heights(5, x, y, z);
  const Real rise = (z[1] - z[2]) * Real(S(0.5 / kReach));
  const Real rise_left = (z[3] - z[4]) * Real(S(0.5 / kReach));
  contact.p_WG = {p.x, p.y, z[0]};
  contact.normal_W =
      Normalized(Vec3<Real>{rise_left * ahead.y - rise * ahead.x,
                            Real(-1) * (rise * ahead.y + rise_left * ahead.x), Real(1)});
}

/// Samples the ground under every contact point that may touch it before the next sample; a point
/// high above all ground around counts as over a level plane.
template <class Real, class Model, class Surface>
void SamplePointContacts(const Model& model, const Surface& ground, const Workspace<Real>& work,
                         EngineState<Real>& state) {
  using S = ScalarOf<Real>;
  constexpr double kHigh = 0.15;  // [m] more than a body falls or tips in one tire step
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto& contact = model.contacts[i];
    const Mat3<Real>& R_WB = work.R_WB[contact.body];
    const Vec3<Real> p = PointOn(state.bodies[contact.body], R_WB, contact.p_B).p;
    Real highest;
    ground.HighestWithin(kHigh, 1, &p.x, &p.y, &highest);
    const auto near = highest + Real(S(kHigh)) > p.z;
    PointContactState<Real>& c = state.contacts[i];
    c.normal_W = {Real(0), Real(0), Real(1)};
    c.p_WG = {p.x, p.y, highest};
    if (!AnyOf(near)) continue;
    PointContactState<Real> sampled = c;
    SampleTangentPlane(ground, R_WB, p, sampled);
    c.p_WG.z = Select(near, sampled.p_WG.z, highest);
    c.normal_W = {Select(near, sampled.normal_W.x, Real(0)),
                  Select(near, sampled.normal_W.y, Real(0)),
                  Select(near, sampled.normal_W.z, Real(1))};
  }
}

/// Tangential force of a bristle under the normal force `push`; the bristle yields where needed.
template <class Real, class Contact>
Vec3<Real> BristleForce(const Contact& contact, const Vec3<Real>& v_slide, const Real& push,
                        double step, PointContactState<Real>& state) {
  using S = ScalarOf<Real>;
  const Vec3<Real>& n = state.normal_W;
  Vec3<Real> bristle = state.bristle_W + ToLanes<Real>(step) * v_slide;
  bristle -= Dot(bristle, n) * n;
  const Real stiffness = ToLanes<Real>(contact.tangential_stiffness);
  const Real most = ToLanes<Real>(contact.friction) * push;
  const Real tiny{S(1e-12)};
  const Real stretch = Norm(bristle);
  bristle = Min(Real(1), most / Max(stiffness * stretch, tiny)) * bristle;
  state.bristle_W = bristle;
  const Vec3<Real> f =
      Real(-1) * (stiffness * bristle + ToLanes<Real>(contact.tangential_damping) * v_slide);
  return Min(Real(1), most / Max(Norm(f), tiny)) * f;
}

template <class Real, class Model>
void AddContactForces(const Model& model, double step, EngineState<Real>& state,
                      Workspace<Real>& work) {
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto& contact = model.contacts[i];
    PointContactState<Real>& c = state.contacts[i];
    const auto point = PointOn(state.bodies[contact.body], work.R_WB[contact.body], contact.p_B);
    const Real depth = Dot(c.p_WG - point.p, c.normal_W);
    const Real rate = Real(-1) * Dot(point.v, c.normal_W);
    const Real elastic = ToLanes<Real>(contact.stiffness) * depth;
    const Real push = elastic + ToLanes<Real>(contact.damping) * rate;
    const Real zero(0);
    // The damper at most doubles the elastic force and never pulls: no jump at first touch.
    const Real normal = Select(depth > zero, Clamp(push, zero, elastic + elastic), zero);
    const Vec3<Real> v_slide = point.v + rate * c.normal_W;
    const Vec3<Real> f = normal * c.normal_W + BristleForce(contact, v_slide, normal, step, c);
    work.wrench[contact.body].Add(f, point.lever);
    work.contact_force[i] = normal;
  }
}

/// Dry friction between two bodies.
template <class Real, class Model>
void AddFrictionForces(const Model& model, double step, EngineState<Real>& state,
                       Workspace<Real>& work) {
  for (std::size_t i = 0; i < model.frictions.size(); ++i) {
    const auto& friction = model.frictions[i];
    const BodyState<Real>& a = state.bodies[friction.body_a];
    const BodyState<Real>& b = state.bodies[friction.body_b];
    const Vec3<Real> axis = work.R_WB[friction.body_a] * Broadcast<Real>(friction.axis_a);
    const auto on_b = PointOn(b, work.R_WB[friction.body_b], friction.p_B);
    const Vec3<Real> lever_a = on_b.p - a.p_WB;
    const bool slides = friction.motion == FrictionModel::Motion::kSliding;
    const Real rate =
        slides ? Dot(on_b.v - a.v_WB - Cross(a.w_WB, lever_a), axis) : Dot(b.w_WB - a.w_WB, axis);
    const Real limit = ToLanes<Real>(friction.limit);
    const Real give = ToLanes<Real>(friction.limit / friction.stiffness);
    state.frictions[i] =
        Clamp(state.frictions[i] + ToLanes<Real>(step) * rate, Real(-1) * give, give);
    const Real wanted = ToLanes<Real>(friction.stiffness) * state.frictions[i] +
                        ToLanes<Real>(friction.damping) * rate;
    const Real size = Real(-1) * Clamp(wanted, Real(-1) * limit, limit);  // on b
    const Vec3<Real> action = size * axis;
    if (slides) {
      work.wrench[friction.body_b].Add(action, on_b.lever);
      work.wrench[friction.body_a].Add(Real(-1) * action, lever_a);
    } else {
      work.wrench[friction.body_b].t_W += action;
      work.wrench[friction.body_a].t_W -= action;
    }
    work.friction_force[i] = size;
  }
}

template <class Real, class Model>
void AddAppliedLoads(const Model& model, Workspace<Real>& work) {
  for (const auto& load : model.loads) {
    const Mat3<Real>& R_WB = work.R_WB[load.body];
    const Vec3<Real> force = Broadcast<Real>(load.force), torque = Broadcast<Real>(load.torque);
    work.wrench[load.body].Add(load.turns_with_body ? R_WB * force : force,
                               R_WB * Broadcast<Real>(load.p_B));
    work.wrench[load.body].t_W += load.turns_with_body ? R_WB * torque : torque;
  }
}

/// All of the above; costs nothing for a vehicle without them.
template <class Real, class Model, class Surface>
DBD_STAGE void AddContactsAndLoads(const Model& model, const Surface& ground, double step,
                                   bool sample_ground, EngineState<Real>& state,
                                   Workspace<Real>& work) {
  if (sample_ground) SamplePointContacts(model, ground, work, state);
  AddContactForces(model, step, state, work);
  AddFrictionForces(model, step, state, work);
  AddAppliedLoads(model, work);
}

}  // namespace dbd
