#pragma once

#include "brixius.h"
#include "engine_state.h"
#include "janosi_share.h"

namespace dbd {

// Traction and motion resistance of a wheel by the model that the soil asks for. Brixius' relations
// are always evaluated; where a lane stands on another kind of soil, a mask replaces its values, so
// that a lane's result depends neither on its neighbours nor on which models are around.
//
// Known differences of the alternatives from their sources: traction is odd in slip; Wismer & Luth
// use the wheel numeric up to 80, as Brixius' mobility number is; the friction limit of the
// material bounds them all.

/// A wheel's longitudinal law at one load: shear = limit (1 - e^(-rate |s|)), or Janosi's share.
template <class Real>
struct TractionCurve {
  Real capacity;    // shear force at full slip / load
  Real rate;        // of the exponential, or of Janosi's share
  Real janosi;      // 1 where the share is Janosi's, else 0
  Real resistance;  // / load, without the carcass' part that the torque overcomes
  Real carcass;     // torque / (load * rolling radius)
};

template <class Real, class Coefficients>
TractionCurve<Real> BrixiusCurve(const Coefficients& c, const Real& mobility, const Real& slip) {
  return {TractionCapacity(c, mobility), ToLanes<Real>(c.slip_rate), Real(0),
          SoilResistance(c, mobility, slip), ToLanes<Real>(c.carcass_loss)};
}

/// Puts the other models in the place of Brixius where the soil asks for them.
template <class Real, class Tire>
void SelectTractionModel(const Tire& tire, const TireContact<Real>& contact, const Real& load,
                         TractionCurve<Real>& curve) {
  using S = ScalarOf<Real>;
  const auto other = contact.rule.model > Real(S(0.5));
  if (!AnyOf(other)) return;
  const Real area = ToLanes<Real>(tire.area);
  const Real numeric = Clamp(contact.cone_index * area / Max(load, Real(S(kLeastLoad))),
                             Real(S(1e-3)), Real(S(kHardSoilMobility)));
  // Wismer & Luth 1973; all of their resistance acts at the hub.
  curve.capacity = Select(other, Real(S(0.75)), curve.capacity);
  curve.rate = Select(other, Real(S(0.3)) * numeric, curve.rate);
  curve.resistance = Select(other, Real(S(1.2)) / numeric + Real(S(0.04)), curve.resistance);
  const auto bekker = contact.rule.model > Real(S(1.5));
  curve.carcass = Select(other, Select(bekker, curve.carcass, Real(0)), curve.carcass);
  curve.capacity = Select(bekker, contact.rule.capacity, curve.capacity);
  curve.rate = Select(bekker, contact.rule.shear_rate, curve.rate);
  curve.resistance = Select(bekker, contact.rule.resistance, curve.resistance);
  curve.janosi = Select(bekker, Real(1), Real(0));
}

/// Magnitude of the shear force at |slip|, and its derivative.
template <class Real>
struct ShearForce {
  Real force;
  Real stiffness;
};

template <class Real>
ShearForce<Real> ShearAt(const TractionCurve<Real>& curve, const Real& limit, const Real& slip) {
  const Real one(1), size = Abs(slip);
  const Real decay = Exp(Real(-1) * curve.rate * size);
  ShearForce<Real> shear{limit * (one - decay), limit * curve.rate * decay};
  const auto janosi = curve.janosi > Real(0);
  if (!AnyOf(janosi)) return shear;
  const JanosiValue<Real> here = JanosiShareOf<Real>(curve.rate * size);
  const Real full = limit / Max(JanosiShareOf(curve.rate).share, ToLanes<Real>(1e-9));
  shear.force = Select(janosi, full * here.share, shear.force);
  shear.stiffness = Select(janosi, full * curve.rate * here.slope, shear.stiffness);
  return shear;
}

}  // namespace dbd
