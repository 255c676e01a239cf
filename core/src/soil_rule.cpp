#include "soil_rule.h"

#include "janosi_share.h"

namespace dbd {

SoilRule<double> BekkerRule(const BekkerSoil& soil, const TireSize& tire, double deflection) {
  SoilRule<double> rule{static_cast<double>(TractionModel::kBekker), 0, 0, 0};
  const double load = tire.stiffness * deflection;
  if (load <= 0) return rule;
  const BekkerWheelForces forces = BekkerWheel(soil, {load, tire.width, tire.diameter, deflection});
  rule.shear_rate = forces.contact_length / soil.shear_deformation;
  rule.capacity = forces.shear_strength / load * JanosiShareOf(rule.shear_rate).share;
  rule.resistance = forces.resistance / load;
  return rule;
}

}  // namespace dbd
