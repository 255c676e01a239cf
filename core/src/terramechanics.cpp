#include <dbd/core/terramechanics.h>

#include <algorithm>
#include <cmath>

#include "brixius.h"

namespace dbd {

double WheelNumeric(double cone_index, double load, double width, double diameter) {
  return cone_index * width * diameter / load;
}

double BrixiusMobilityNumber(double cone_index, double load, double width, double diameter,
                             double deflection_ratio) {
  return WheelNumeric(cone_index, load, width, diameter) * (1 + 5 * deflection_ratio) /
         (1 + 3 * width / diameter);
}

BrixiusCoefficients BiasCoefficients() { return {}; }

BrixiusCoefficients RadialCoefficients() { return {0.88, 0.1, 9.5, 0.0325, 0.9, 0.5}; }

double GrossTractionRatio(const BrixiusCoefficients& c, double mobility, double slip) {
  const double shear = 1 - std::exp(-c.slip_rate * std::abs(slip));
  return std::copysign(TractionCapacity(c, mobility) * shear, slip) + c.carcass_loss;
}

double MotionResistanceRatio(const BrixiusCoefficients& c, double mobility, double slip) {
  return SoilResistance(c, mobility, slip) + c.carcass_loss;
}

double NetTractionRatio(const BrixiusCoefficients& c, double mobility, double slip) {
  return GrossTractionRatio(c, mobility, slip) - MotionResistanceRatio(c, mobility, slip);
}

NetTractionOptimum MaxNetTraction(const BrixiusCoefficients& c, double mobility) {
  // NTR is concave in slip: d/ds = A(1-e^(-k1 B)) k2 e^(-k2 s) - m2/sqrt(B) vanishes once.
  const double initial = TractionCapacity(c, mobility) * c.slip_rate;
  const double loss = c.resistance_slip / std::sqrt(mobility);
  const double slip = std::clamp(std::log(initial / loss) / c.slip_rate, 0.0, 1.0);
  return {NetTractionRatio(c, mobility, slip), slip};
}

double Slip(double peripheral_speed, double forward_speed, double floor_speed) {
  const double scale = std::max({std::abs(peripheral_speed), std::abs(forward_speed), floor_speed});
  return (peripheral_speed - forward_speed) / scale;
}

double LoadedRollingRadius(double radius, double deflection) {
  return RollingRadius(radius, deflection);
}

double LinesMurphyStiffness(double rim_diameter, double width, double pressure, double age_years) {
  const double rim = rim_diameter / 0.0254;
  const double section = width / 0.0254;
  const double bar = pressure / 1e5;
  return 1e3 * (172 - 1.77 * rim + 5.6 * age_years + 0.34 * rim * section * bar);
}

}  // namespace dbd
