#pragma once

#include "engine_state.h"
#include "tire_numbers.h"
#include "traction_models.h"

namespace dbd {

// The force law of a tire between two samples of the ground (paper section 4.5): normal force from
// the deflection, traction and motion resistance by the soil's model (Brixius unless the material
// says otherwise), lateral force exponential in the slip angle (Crolla & El-Razaz 1987) inside a
// traction ellipse (Janosi et al. 1981).
//
// Differences from the source, each needed for a stable and accurate step:
// - Slip and slip angle build up over a relaxation length, s' = (u - v - max(|u|,|v|) s) / sigma.
//   The algebraic laws are dampers that become infinitely stiff as the vehicle stops, and they
//   creep on a slope; the relaxed ones turn into springs, so that a braked vehicle stands.
// - Below about 1 m/s those springs get a damper (`kBristleTime` times their stiffness).
// - Spin is advanced semi-implicitly, and the same updated force acts on the wheel's body.
// - The deflection follows the hub along the contact normal between samples (SPLIT).
//
// The law is written in stages, each of which goes over all wheels before the next begins: within
// a wheel nearly every operation waits for the last, and the processor fills the waiting time with
// the next wheel only where that is near.

// About 0.3 of critical for a vehicle that rocks to and fro on its shear springs, near 2 Hz.
inline constexpr double kBristleTime = 0.04;     // [s]
inline constexpr double kBristleSpeed = 1.0;     // [m/s] where the bristle damper has halved
inline constexpr double kResistanceSpeed = 0.1;  // [m/s] over which resistance changes its sign
inline constexpr double kEllipseFloor = 0.02;    // least share of (lateral / full)^2

/// One tire's forces before its spin is known: traction is linear in the spin around `spin0`.
template <class Real>
struct TireLaw {
  Vec3<Real> normal_W, forward_W, left_W;  // contact frame
  Real vx, vy;                             // of the contact point, along forward and left
  Real load;
  Real rolling_radius;
  Real capacity;          // shear force at full slip / load
  Real traction0;         // shear force at the spin of the last step
  Real traction_by_spin;  // its derivative [N s/rad]
  Real traction_limit;    // shear force at full slip
  TractionCurve<Real> curve;
  Real carcass_torque;  // opposes rolling
  Real resistance;      // along forward, negative when rolling forward
  Real lateral;
  Real slip_gain;  // slip after the step = slip_base + slip_gain * spin
  Real slip_base;
};

/// Speeds of the contact point, without the part of the hub's motion about its spin axis.
template <class Real>
Vec3<Real> ContactVelocity(const BodyState<Real>& body, const Vec3<Real>& hub_lever,
                           const Vec3<Real>& y_W, const Vec3<Real>& p_HC_W) {
  const Vec3<Real> w = body.w_WB - Dot(body.w_WB, y_W) * y_W;
  return body.v_WB + Cross(body.w_WB, hub_lever) + Cross(w, p_HC_W);
}

template <class Real, class Tire>
Real NormalLoad(const Tire& tire, const TireContact<Real>& contact, const Vec3<Real>& p_WH,
                const Vec3<Real>& v_C) {
  const Real advance = Dot(p_WH - contact.p_WH, contact.normal_W);
  const Real deflection = contact.deflection - advance;
  const Real rate = Real(-1) * Dot(v_C, contact.normal_W);
  const Real load = ToLanes<Real>(tire.stiffness) * deflection + ToLanes<Real>(tire.damping) * rate;
  const Real zero(0);
  const Real touching = Select(contact.deflection > zero, load, zero);
  return Select(deflection > zero, Max(touching, zero), zero);
}

/// Stage 1: contact frame, speeds and wheel load.
template <class Real, class Tire>
void MeetGround(const Tire& tire, const BodyState<Real>& body, const Vec3<Real>& hub_lever,
                const Vec3<Real>& y_W, const TireContact<Real>& contact, TireLaw<Real>& law) {
  const Vec3<Real> v_C = ContactVelocity(body, hub_lever, y_W, contact.p_HC_W);
  law.normal_W = contact.normal_W;
  law.forward_W = Normalized(Cross(y_W, contact.normal_W));
  law.left_W = Cross(law.normal_W, law.forward_W);
  law.load = NormalLoad(tire, contact, body.p_WB + hub_lever, v_C);
  law.vx = Dot(v_C, law.forward_W);
  law.vy = Dot(v_C, law.left_W);
}

/// Stage 2: what the soil can take, and what it resists.
template <class Real, class Tire>
void MeetSoil(const Tire& tire, const WheelState<Real>& wheel, TireLaw<Real>& law) {
  using S = ScalarOf<Real>;
  const TireContact<Real>& contact = wheel.contact;
  const Real deflection = law.load * ToLanes<Real>(tire.by_stiffness);
  law.rolling_radius = RollingRadius(tire.radius, deflection);
  const Real mobility = MobilityNumber(contact.cone_index, law.load, deflection, tire.area,
                                       tire.by_height, tire.by_shape);
  law.curve = BrixiusCurve(tire.traction, mobility, wheel.slip);
  SelectTractionModel(tire, contact, law.load, law.curve);
  law.capacity = Min(law.curve.capacity, contact.friction_limit);
  law.traction_limit = law.capacity * law.load;
  const Real v1{S(kResistanceSpeed)};
  const Real rolling = law.load * law.vx / Sqrt(law.vx * law.vx + v1 * v1);
  law.resistance = Real(-1) * rolling * law.curve.resistance;
  law.carcass_torque = law.curve.carcass * rolling * law.rolling_radius;
}

/// The damper of the shear springs, per speed, fading out above walking pace.
template <class Real, class Tire>
Real BristleDamper(const Tire& tire, const Real& vx) {
  using S = ScalarOf<Real>;
  const Real low = vx * Real(S(1 / kBristleSpeed));
  return ToLanes<Real>(tire.bristle_damping) / (Real(1) + low * low);
}

/// Stage 3, longitudinal: relaxed slip, traction and its slope against spin.
template <class Real, class Tire>
void SetTraction(const Tire& tire, const WheelState<Real>& wheel, TireLaw<Real>& law) {
  const Real one(1);
  const Real& vx = law.vx;
  const Real u = wheel.spin * law.rolling_radius;
  const Real speed = Max(Abs(u), Abs(vx));
  const Real ratio = ToLanes<Real>(tire.step_by_length);
  const Real gain = ratio / (one + speed * ratio);
  const Real damper = BristleDamper(tire, vx);
  law.slip_gain = gain * law.rolling_radius;
  law.slip_base = gain * (wheel.slip * ToLanes<Real>(tire.length_by_step) - vx);

  const Real relaxed = Clamp(law.slip_base + law.slip_gain * wheel.spin, Real(-1), one);
  const Real slip = Clamp(relaxed + damper * (u - vx), Real(-1), one);
  const ShearForce<Real> shear = ShearAt(law.curve, law.traction_limit, slip);
  law.traction0 = Select(slip < Real(0), Real(-1) * shear.force, shear.force);
  law.traction_by_spin = shear.stiffness * (law.slip_gain + damper * law.rolling_radius);
}

/// Stage 4, lateral: relaxed slip angle, exponential law, ellipse with the traction in use.
template <class Real, class Tire>
void SetLateral(const Tire& tire, WheelState<Real>& wheel, TireLaw<Real>& law) {
  using S = ScalarOf<Real>;
  const Real one(1);
  const Real ratio = ToLanes<Real>(tire.step_by_length);
  const Real relaxed = (wheel.slip_angle + ratio * law.vy) / (one + ratio * Abs(law.vx));
  wheel.slip_angle = Select(law.load > Real(0), Clamp(relaxed, Real(-1), one), Real(0));
  const Real angle = wheel.slip_angle + BristleDamper(tire, law.vx) * law.vy;
  const Real use = law.traction0 / Max(law.traction_limit, Real(S(kLeastLoad)));
  const Real ellipse = Sqrt(Max(one - use * use, Real(S(kEllipseFloor))));
  const Real limit = ToLanes<Real>(tire.lateral_share) * law.capacity * law.load;
  const Real size = limit * ellipse * (one - Exp(ToLanes<Real>(-tire.lateral_rate) * Abs(angle)));
  law.lateral = Select(angle < Real(0), size, Real(-1) * size);
}

}  // namespace dbd
