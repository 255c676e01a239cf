#include <dbd/core/soil_strength.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dbd {
namespace {

constexpr double kPound = 4.4482216;       // [N]
constexpr double kHorsepower = 745.69987;  // [W]
constexpr double kTon = 2000 * kPound;     // [N]

/// ln(psi) = c1 + c2 ln(moisture), for CI and RCI.
struct MoistureFit {
  UscsClass soil;
  const char* name;
  double ci1, ci2, rci1, rci2;
};

constexpr std::array<MoistureFit, 12> kFits = {{
    {UscsClass::kSW, "SW", 3.987, 0.815, 3.987, 0.815},
    {UscsClass::kSP, "SP", 3.987, 0.815, 3.987, 0.815},
    {UscsClass::kSM, "SM", 8.749, -1.1949, 12.542, -2.955},
    {UscsClass::kSC, "SC", 9.056, -1.3566, 12.542, -2.955},
    {UscsClass::kSMSC, "SM-SC", 9.056, -1.3566, 12.542, -2.955},
    {UscsClass::kML, "ML", 10.225, -1.565, 11.936, -2.407},
    {UscsClass::kCLML, "CL-ML", 9.454, -1.385, 14.236, -3.137},
    {UscsClass::kCL, "CL", 10.998, -1.848, 15.506, -3.53},
    {UscsClass::kOL, "OL", 10.977, -1.754, 17.399, -3.584},
    {UscsClass::kCH, "CH", 13.816, -2.583, 13.686, -2.705},
    {UscsClass::kMH, "MH", 12.321, -2.044, 23.641, -5.191},
    {UscsClass::kOH, "OH", 13.046, -2.172, 12.189, -1.942},
}};

}  // namespace

double RatingConeIndex(double cone_index, double remoulding_index) {
  return cone_index * remoulding_index;
}

double MobilityWeightFactor(double axle_load) {
  const double kip = axle_load / (1000 * kPound);
  if (kip < 2) return 0.553 * kip;
  if (kip <= 13.5) return 0.033 * kip + 1.05;
  if (kip <= 20) return 0.142 * kip - 0.42;
  return 0.278 * kip - 3.115;
}

MobilityIndexFactors FactorsOf(const MobilityIndexVehicle& vehicle) {
  const double pounds = vehicle.weight / kPound;
  const double width = vehicle.tire_width / Inches(1);
  const double radius = vehicle.tire_diameter / Inches(2);
  MobilityIndexFactors factors;
  factors.contact_pressure = pounds / (width * vehicle.tires * radius);
  factors.weight = MobilityWeightFactor(vehicle.weight / vehicle.axles);
  factors.tire = (10 + width) / 100;
  factors.grouser = vehicle.chains ? 1.05 : 1.0;
  factors.wheel_load = pounds / 1000 / (2 * vehicle.axles);
  factors.clearance = vehicle.clearance / Inches(10);
  const double power_per_ton = vehicle.power / kHorsepower / (vehicle.weight / kTon);
  factors.engine = power_per_ton >= 10 ? 1.0 : 1.05;
  factors.transmission = vehicle.automatic_transmission ? 1.0 : 1.05;
  return factors;
}

double MobilityIndex(const MobilityIndexFactors& f) {
  const double pressure = f.contact_pressure * f.weight / (f.tire * f.grouser);
  return (pressure + f.wheel_load - f.clearance) * f.engine * f.transmission;
}

double VehicleConeIndexOnePass(double mobility_index, double deflection_ratio) {
  const double correction = std::pow(0.15 / deflection_ratio, 0.25);
  const double psi = mobility_index <= 115
                         ? 11.48 + 0.2 * mobility_index - 39.2 / (mobility_index + 3.74)
                         : 4.1 * std::pow(mobility_index, 0.446);
  return Psi(psi * correction);
}

double VehicleConeIndexFiftyPasses(double mobility_index) {
  return Psi(28.23 + 0.43 * mobility_index - 92.67 / (mobility_index + 3.67));
}

double TrackedConeIndexOnePass(double mobility_index) {
  return Psi(7.0 + 0.2 * mobility_index - 39.2 / (mobility_index + 5.6));
}

double TrackedConeIndexFiftyPasses(double mobility_index) {
  return Psi(19.27 + 0.43 * mobility_index - 125.79 / (mobility_index + 7.08));
}

double MaclaurinNumeric(double cone_index, double load, double width, double diameter,
                        double deflection) {
  return cone_index * std::pow(width * diameter, 0.8) * std::pow(deflection, 0.4) / load;
}

double LimitingConeIndex(double load, double width, double diameter, double deflection) {
  return 1.85 / MaclaurinNumeric(1.0, load, width, diameter, deflection);
}

double NrmmPullRatio(const NrmmCurve& curve, double excess) {
  const double x = excess / Psi(1);
  const double sum = curve.a + curve.c * x;
  return sum - std::sqrt(sum * sum - curve.e * x);
}

double NrmmResistanceRatio(const NrmmCurve& curve, double excess) {
  return curve.resistance + curve.slope / (excess / Psi(1) + curve.offset);
}

std::optional<UscsClass> UscsClassOf(const std::string& name) {
  for (const MoistureFit& fit : kFits) {
    if (name == fit.name) return fit.soil;
  }
  return std::nullopt;
}

std::string UscsName(UscsClass soil) { return kFits[static_cast<std::size_t>(soil)].name; }

SoilStrength FittedSoilStrength(UscsClass soil, double moisture) {
  const MoistureFit& fit = kFits[static_cast<std::size_t>(soil)];
  const double log_moisture = std::log(moisture);
  return {Psi(std::exp(fit.ci1 + fit.ci2 * log_moisture)),
          Psi(std::exp(fit.rci1 + fit.rci2 * log_moisture))};
}

SoilStrength SoilStrengthAt(UscsClass soil, double moisture) {
  const auto keep = [](double value) { return std::clamp(value, Psi(1), Psi(300)); };
  const SoilStrength fitted = FittedSoilStrength(soil, moisture);
  const bool sand = soil == UscsClass::kSW || soil == UscsClass::kSP;
  SoilStrength strength{keep(fitted.cone_index), keep(fitted.rating_cone_index)};
  if (!sand) {
    strength.rating_cone_index = std::min(strength.rating_cone_index, strength.cone_index);
  }
  return strength;
}

std::optional<MoistureState> MoistureStateOf(const std::string& name) {
  if (name == "dry") return MoistureState::kDry;
  if (name == "moist") return MoistureState::kMoist;
  if (name == "wet") return MoistureState::kWet;
  return std::nullopt;
}

double MoistureFactor(UscsClass soil, MoistureState state) {
  constexpr std::array<double, 3> kMoistures = {12, 22, 35};  // [% of dry weight]
  const bool holds_more =
      soil == UscsClass::kCH || soil == UscsClass::kMH || soil == UscsClass::kOH;
  const auto strength = [&](MoistureState at) {
    const double moisture = kMoistures[static_cast<std::size_t>(at)] + (holds_more ? 10 : 0);
    return SoilStrengthAt(soil, moisture).cone_index;
  };
  return strength(state) / strength(MoistureState::kMoist);
}

double MovementSpeed(const MovementFactors& factors) {
  const double slope = (factors.max_off_road_slope - factors.slope) * factors.max_road_speed /
                       factors.max_on_road_slope;
  const double contours = (280 - 5 * factors.contour_crossings) / 280;
  return std::max(0.0, slope) * std::max(0.0, contours) * factors.vegetation * factors.soil *
         factors.roughness;
}

}  // namespace dbd
