#pragma once

#include <dbd/core/vehicle_model.h>

#include "scalar.h"

namespace dbd {

// Brixius (1987) wheel equations as adopted by ASAE/ASABE D497, for any lane type.
//
//   C_n = CI b d / W                              wheel numeric
//   B_n = C_n (1 + 5 delta/h) / (1 + 3 b/d)       mobility number
//   GTR = A (1 - e^(-k1 B_n)) (1 - e^(-k2 s)) + ct
//   MRR = m1/B_n + ct + m2 s / sqrt(B_n)
//
// Known differences: the carcass term ct stands in GTR and MRR alike and cancels in the net pull
// (the source prints it in both; some codes drop it from GTR). The curve is continued to negative
// slip as an odd function, a convention, since Brixius measured no braking. delta is the tire's
// deflection on a hard surface, load / stiffness, never the sinkage.

/// Largest B_n used: beyond it the relations are flat and the soil is "hard" (D497 class 80).
inline constexpr double kHardSoilMobility = 80.0;

/// Loads below this are treated as this in quotients; the forces still vanish with the load.
inline constexpr double kLeastLoad = 1.0;  // [N]

/// `area`: width times diameter; `by_height`: 5 / section height; `by_shape`: 1 / (1 + 3 b / d).
template <class Real, class Number>
Real MobilityNumber(const Real& cone_index, const Real& load, const Real& deflection,
                    const Number& area, const Number& by_height, const Number& by_shape) {
  using S = ScalarOf<Real>;
  const Real numeric = cone_index * ToLanes<Real>(area) / Max(load, Real(S(kLeastLoad)));
  const Real shape = (Real(1) + deflection * ToLanes<Real>(by_height)) * ToLanes<Real>(by_shape);
  return Min(numeric * shape, Real(S(kHardSoilMobility)));
}

/// The gross traction ratio that a wheel reaches at full slip, less ct.
template <class Real, class Coefficients>
Real TractionCapacity(const Coefficients& c, const Real& mobility) {
  return ToLanes<Real>(c.traction_max) *
         (Real(1) - Exp(ToLanes<Real>(-c.mobility_rate) * mobility));
}

/// Motion resistance ratio without ct; `slip` may be negative, its magnitude counts.
template <class Real, class Coefficients>
Real SoilResistance(const Coefficients& c, const Real& mobility, const Real& slip) {
  const Real b = Max(mobility, ToLanes<Real>(1e-3));
  return ToLanes<Real>(c.resistance_mobility) / b +
         ToLanes<Real>(c.resistance_slip) * Abs(slip) / Sqrt(b);
}

/// Rolling radius from the unloaded radius and the deflection (Brixius; terramechanics 1.4):
/// r = 2.5 R L / (1.5 R + L) with L the static loaded radius.
template <class Real, class Number>
Real RollingRadius(const Number& radius, const Real& deflection) {
  const Real loaded = ToLanes<Real>(radius) - deflection;
  return ToLanes<Real>(2.5 * radius) * loaded / (ToLanes<Real>(1.5 * radius) + loaded);
}

}  // namespace dbd
