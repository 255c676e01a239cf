#pragma once

#include "engine_state.h"
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

// About 0.3 of critical for a vehicle that rocks to and fro on its shear springs, near 2 Hz.
inline constexpr double kBristleTime = 0.04;     // [s]
inline constexpr double kBristleSpeed = 1.0;     // [m/s] where the bristle damper has halved
inline constexpr double kResistanceSpeed = 0.1;  // [m/s] over which resistance changes its sign
inline constexpr double kEllipseFloor = 0.02;    // least share of (lateral / full)^2

/// One tire's forces before its spin is known: traction is linear in the spin around `spin0`.
template <class Real>
struct TireLaw {
  Vec3<Real> normal_W, forward_W, left_W;  // contact frame
  Real load;
  Real rolling_radius;
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

/// Longitudinal part: relaxed slip, traction and its slope against spin.
template <class Real, class Tire>
void SetTraction(const Tire& tire, const WheelState<Real>& wheel, const Real& vx, double step,
                 TireLaw<Real>& law) {
  using S = ScalarOf<Real>;
  const Real one(1);
  const auto sigma = tire.relaxation_length;
  const Real u = wheel.spin * law.rolling_radius;
  const Real speed = Max(Abs(u), Abs(vx));
  const Real gain = ToLanes<Real>(step / sigma) / (one + speed * ToLanes<Real>(step / sigma));
  const Real low = vx * Real(S(1 / kBristleSpeed));
  const Real damper = ToLanes<Real>(kBristleTime / sigma) / (one + low * low);
  law.slip_gain = gain * law.rolling_radius;
  law.slip_base = gain * (wheel.slip * ToLanes<Real>(sigma / step) - vx);

  const Real relaxed = Clamp(law.slip_base + law.slip_gain * wheel.spin, Real(-1), one);
  const Real slip = Clamp(relaxed + damper * (u - vx), Real(-1), one);
  const ShearForce<Real> shear = ShearAt(law.curve, law.traction_limit, slip);
  law.traction0 = Select(slip < Real(0), Real(-1) * shear.force, shear.force);
  law.traction_by_spin = shear.stiffness * (law.slip_gain + damper * law.rolling_radius);
}

/// Lateral part: relaxed slip angle, exponential law, ellipse with the traction in use.
template <class Real, class Tire>
void SetLateral(const Tire& tire, const Real& vx, const Real& vy, double step, const Real& capacity,
                WheelState<Real>& wheel, TireLaw<Real>& law) {
  using S = ScalarOf<Real>;
  const Real one(1);
  const Real ratio = ToLanes<Real>(step / tire.relaxation_length);
  const Real relaxed = (wheel.slip_angle + ratio * vy) / (one + ratio * Abs(vx));
  wheel.slip_angle = Select(law.load > Real(0), Clamp(relaxed, Real(-1), one), Real(0));
  const Real low = vx * Real(S(1 / kBristleSpeed));
  const Real damper = ToLanes<Real>(kBristleTime / tire.relaxation_length) / (one + low * low);
  const Real angle = wheel.slip_angle + damper * vy;
  const Real use = law.traction0 / Max(law.traction_limit, Real(S(kLeastLoad)));
  const Real ellipse = Sqrt(Max(one - use * use, Real(S(kEllipseFloor))));
  const Real limit =
      ToLanes<Real>(tire.lateral_limit / tire.traction.traction_max) * capacity * law.load;
  const Real size = limit * ellipse * (one - Exp(ToLanes<Real>(-tire.lateral_rate) * Abs(angle)));
  law.lateral = Select(angle < Real(0), size, Real(-1) * size);
}

/// Everything about one tire that does not need the new spin.
template <class Real, class Wheel>
TireLaw<Real> EvaluateTire(const Wheel& model, const BodyState<Real>& body,
                           const Vec3<Real>& hub_lever, const Vec3<Real>& y_W, double step,
                           WheelState<Real>& wheel) {
  using S = ScalarOf<Real>;
  const auto& tire = model.tire;
  const TireContact<Real>& contact = wheel.contact;
  const Vec3<Real> v_C = ContactVelocity(body, hub_lever, y_W, contact.p_HC_W);

  TireLaw<Real> law;
  law.normal_W = contact.normal_W;
  law.forward_W = Normalized(Cross(y_W, contact.normal_W));
  law.left_W = Cross(law.normal_W, law.forward_W);
  law.load = NormalLoad(tire, contact, body.p_WB + hub_lever, v_C);
  const Real vx = Dot(v_C, law.forward_W);
  const Real vy = Dot(v_C, law.left_W);

  const Real deflection = law.load * ToLanes<Real>(1 / tire.stiffness);
  law.rolling_radius = RollingRadius(tire.radius, deflection);
  const Real mobility = MobilityNumber(contact.cone_index, law.load, deflection, tire.width,
                                       2 * tire.radius, tire.section_height);
  law.curve = BrixiusCurve(tire.traction, mobility, wheel.slip);
  SelectTractionModel(tire, contact, law.load, law.curve);
  const Real capacity = Min(law.curve.capacity, contact.friction_limit);
  law.traction_limit = capacity * law.load;
  SetTraction(tire, wheel, vx, step, law);
  SetLateral(tire, vx, vy, step, capacity, wheel, law);

  const Real v1{S(kResistanceSpeed)};
  const Real rolling = law.load * vx / Sqrt(vx * vx + v1 * v1);
  law.resistance = Real(-1) * rolling * law.curve.resistance;
  law.carcass_torque = law.curve.carcass * rolling * law.rolling_radius;
  return law;
}

}  // namespace dbd
