#include <dbd/core/terramechanics.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

namespace dbd {

TractionRatios WismerLuthTraction(double wheel_numeric, double slip) {
  TractionRatios ratios;
  const double shear = 0.75 * (1 - std::exp(-0.3 * wheel_numeric * std::abs(slip)));
  ratios.gross = std::copysign(shear, slip);
  ratios.resistance = 1.2 / wheel_numeric + 0.04;
  ratios.net = ratios.gross - ratios.resistance;
  return ratios;
}

double TurnageMobilityNumber(double cone_index, double load, double width, double diameter,
                             double deflection_ratio) {
  return WheelNumeric(cone_index, load, width, diameter) * std::sqrt(deflection_ratio) /
         (1 + width / (2 * diameter));
}

GeeCloughTraction GeeCloughNetTraction(double mobility, double slip) {
  GeeCloughTraction traction;
  traction.max_net = 0.796 - 0.92 / mobility;
  traction.rate = (4.838 + 0.061 * mobility) / traction.max_net;
  traction.net = traction.max_net * (1 - std::exp(-traction.rate * slip));
  traction.towed_resistance = 0.049 + 0.287 / mobility;
  return traction;
}

ClayNumerics FineGrainedNumerics(double cone_index, double load, double width, double diameter,
                                 double deflection_ratio) {
  ClayNumerics numerics;
  const double left = 1 - std::min(deflection_ratio, 0.9), shape = 1 + width / diameter;
  // Powers of 3/2, 3/4 and 5/2 as roots: a tenth of the time, and drives ask often.
  numerics.uncorrected = WheelNumeric(cone_index, load, width, diameter) / (left * std::sqrt(left));
  numerics.numeric = numerics.uncorrected / std::sqrt(shape * std::sqrt(shape));
  const double squared = numerics.numeric * numerics.numeric;
  numerics.self_propelled_slip =
      std::min(21 / (squared * std::sqrt(numerics.numeric)) + 0.005, 1.0);
  return numerics;
}

TractionRatios FineGrainedTraction(const ClayNumerics& numerics, double width, double diameter,
                                   double slip) {
  TractionRatios ratios;
  ratios.net =
      0.5 * std::log10(slip / numerics.self_propelled_slip) * std::pow(1 + width / diameter, 0.25);
  ratios.resistance = 12 / (numerics.numeric * numerics.numeric) + 0.007;
  ratios.gross = ratios.net + ratios.resistance;
  return ratios;
}

double FineGrainedTowedResistance(const ClayNumerics& numerics) {
  return 5.07 / std::pow(numerics.numeric, 1.71) + 0.011;
}

double SandGradient(double cone_index) { return cone_index / (3.47 * Inches(1)); }

double SandNumeric(double gradient, double load, double width, double diameter,
                   double deflection_ratio) {
  return gradient * std::pow(width * diameter, 1.5) * deflection_ratio / load;
}

double SandGrossTraction(double sand_numeric, double slip) {
  const double firm = sand_numeric + 10;
  return 0.66 * firm * slip / ((firm + 4.71) * slip + 1.72);
}

LateralCoefficients BiasLateralCoefficients(double mobility) {
  const double limit = std::min(0.61 + 0.69 / mobility, 1.0);
  return {limit, (2.34 + 0.088 * mobility) / limit};
}

LateralCoefficients RadialLateralCoefficients(double mobility) {
  return {0.8, (2.79 + 0.16 * mobility) / 0.8};
}

double LateralForceRatio(const LateralCoefficients& c, double angle) {
  return c.limit * (1 - std::exp(-c.rate * std::abs(angle)));
}

double EllipseLateralForce(double lateral, double traction, double traction_limit) {
  const double use = traction / traction_limit;
  return lateral * std::sqrt(std::max(0.0, 1 - use * use));
}

CombinedForces NicolasComstockForces(const PureSlipForces& pure, double slip, double angle) {
  const double x = pure.longitudinal, y = pure.lateral;
  const double cs = pure.longitudinal_stiffness, ca = pure.lateral_stiffness;
  const double tangent = std::tan(angle);
  const double both = x * y / std::hypot(slip * y, x * tangent);
  const double rolling = (1 - slip) * std::cos(angle);
  return {both * slip * std::hypot(slip * ca, rolling * x) / (slip * ca),
          both * tangent * std::hypot(rolling * y, std::sin(angle) * cs) / (cs * std::sin(angle))};
}

double ContactLength(double radius, double deflection) {
  return 2 * std::sqrt(radius * std::max(deflection, 0.0));
}

double PneumaticTrail(double contact_length, double lateral_slip) {
  constexpr double kTrailShare = 0.178, kLastSlip = 0.365;
  return kTrailShare * contact_length * std::max(0.0, 1 - std::abs(lateral_slip) / kLastSlip);
}

}  // namespace dbd
