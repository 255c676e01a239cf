#pragma once

#include <dbd/core/ground.h>

#include "engine_state.h"

namespace dbd {

// Bekker's wheel needs powers of load and soil constants. They are evaluated lane by lane when the
// ground is sampled, as ratios per load that hold until the next sample, as the geometry does.

struct TireSize {
  double width, diameter, stiffness;
};

/// One lane: thrust at full slip and resistance, each per load, and contact length over K.
SoilRule<double> BekkerRule(const BekkerSoil& soil, const TireSize& tire, double deflection);

/// `soil`: one per lane.
template <class Real, class Pattern>
SoilRule<Real> MakeSoilRule(const SoilSample* soil, const Pattern& tire, const Real& deflection) {
  using S = ScalarOf<Real>;
  using Lanes = LaneTraits<Real>;
  S deflections[Lanes::kLanes], model[Lanes::kLanes];
  S capacity[Lanes::kLanes], shear_rate[Lanes::kLanes], resistance[Lanes::kLanes];
  Lanes::Store(deflection, deflections);
  for (int i = 0; i < Lanes::kLanes; ++i) {
    SoilRule<double> rule{static_cast<double>(soil[i].traction_model), 0, 0, 0};
    if (soil[i].traction_model == TractionModel::kBekker) {
      const TireSize size{NumberOf(tire.width, i), 2 * NumberOf(tire.radius, i),
                          NumberOf(tire.stiffness, i)};
      rule = BekkerRule(soil[i].plate, size, static_cast<double>(deflections[i]));
    }
    model[i] = static_cast<S>(rule.model);
    capacity[i] = static_cast<S>(rule.capacity);
    shear_rate[i] = static_cast<S>(rule.shear_rate);
    resistance[i] = static_cast<S>(rule.resistance);
  }
  return {Lanes::Load(model), Lanes::Load(capacity), Lanes::Load(shear_rate),
          Lanes::Load(resistance)};
}

}  // namespace dbd
