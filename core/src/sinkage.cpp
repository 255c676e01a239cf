#include <dbd/core/sinkage.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

constexpr double kPound = 4.4482216;  // [N]

double ClayNumeric(const WheelFooting& w) {
  return FineGrainedNumerics(w.cone_index, w.load, w.width, w.diameter, w.deflection_ratio)
      .uncorrected;
}

}  // namespace

double PoweredSinkage(double cone_index, double load, double width, double diameter,
                      double deflection_ratio) {
  const ClayNumerics numerics =
      FineGrainedNumerics(cone_index, load, width, diameter, deflection_ratio);
  return diameter * 1.64 *
         std::exp(1.21 *
                  (0.19 * std::log(numerics.self_propelled_slip) - std::log(numerics.uncorrected)));
}

// In drives sinkage is asked for every wheel many times a second: roots in place of powers where
// the exponent allows, |s|^(1/3) / N^(5/3) = (|s| N)^(1/3) / N^2.
double PoweredSinkageAtSlip(const WheelFooting& wheel, double slip) {
  const double numeric = ClayNumeric(wheel);
  return wheel.diameter * 5 * std::cbrt(std::abs(slip) * numeric) / (numeric * numeric);
}

double UnpoweredSinkage(const WheelFooting& wheel) {
  return wheel.diameter * std::max(0.0, 2.66 / std::pow(ClayNumeric(wheel), 1.64) - 0.0063);
}

double MaclaurinSinkage(double mobility, double diameter) {
  return 0.224 * diameter / std::pow(mobility, 1.25);
}

double MultipassSinkage(double first_sinkage, int passes, double exponent) {
  return first_sinkage * std::pow(passes, 1 / exponent);
}

double SandSinkage(const WheelFooting& wheel) {
  const double area = wheel.width * wheel.diameter / (Inches(1) * Inches(1));
  const double numeric = wheel.cone_index / Psi(1) * std::pow(area, 1.5) /
                         (wheel.load / kPound * (1 - wheel.deflection_ratio));
  return wheel.diameter * 14 / numeric;
}

double MultipassConeIndexRatio(double brixius_mobility) {
  return std::min(2.0, 1 + 1.8 * std::exp(-0.11 * brixius_mobility));
}

double OperatingSinkage(const WheelFooting& wheel, double slip, int pass,
                        const SinkageOptions& options) {
  if (wheel.load <= 0 || wheel.cone_index <= 0) return 0;
  const double powered = PoweredSinkage(wheel.cone_index, wheel.load, wheel.width, wheel.diameter,
                                        wheel.deflection_ratio);
  const double sinkage = std::max(powered, PoweredSinkageAtSlip(wheel, slip));
  if (options.multipass_exponent <= 0) return sinkage;
  const double mobility = TurnageMobilityNumber(wheel.cone_index, wheel.load, wheel.width,
                                                wheel.diameter, wheel.deflection_ratio);
  const double first = MaclaurinSinkage(mobility, wheel.diameter);
  return std::max(sinkage, MultipassSinkage(first, pass, options.multipass_exponent));
}

}  // namespace dbd
