#include <dbd/core/bekker.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

#include "janosi_share.h"

namespace dbd {

double BekkerPressure(const BekkerSoil& soil, double width, double sinkage) {
  return (soil.kc / width + soil.kphi) * std::pow(sinkage, soil.n);
}

double BekkerSinkage(const BekkerSoil& soil, double width, double pressure) {
  return std::pow(pressure / (soil.kc / width + soil.kphi), 1 / soil.n);
}

double RigidWheelSinkage(const BekkerSoil& soil, double load, double width, double diameter) {
  const double modulus = soil.kc + width * soil.kphi;
  return std::pow(3 * load / ((3 - soil.n) * modulus * std::sqrt(diameter)), 2 / (2 * soil.n + 1));
}

double CompactionResistance(const BekkerSoil& soil, double width, double sinkage) {
  return (soil.kc + width * soil.kphi) * std::pow(sinkage, soil.n + 1) / (soil.n + 1);
}

double ShearStress(const BekkerSoil& soil, double pressure, double displacement) {
  return (soil.cohesion + pressure * std::tan(soil.friction_angle)) *
         (1 - std::exp(-displacement / soil.shear_deformation));
}

double JanosiShare(double x) { return JanosiShareOf(x).share; }

double JanosiThrust(const BekkerSoil& soil, double area, double load, double length, double slip) {
  const double strength = area * soil.cohesion + load * std::tan(soil.friction_angle);
  const double share = JanosiShare(std::abs(slip) * length / soil.shear_deformation);
  return std::copysign(strength * share, slip);
}

BekkerWheelForces BekkerWheel(const BekkerSoil& soil, const BekkerWheelInput& wheel) {
  BekkerWheelForces forces;
  if (wheel.load <= 0 || wheel.deflection <= 0) return forces;
  forces.contact_length = ContactLength(0.5 * wheel.diameter, wheel.deflection);
  const double area = wheel.width * forces.contact_length;
  const double elastic = BekkerSinkage(soil, wheel.width, wheel.load / area);
  const double rigid = RigidWheelSinkage(soil, wheel.load, wheel.width, wheel.diameter);
  forces.sinkage = std::min({elastic, rigid, 0.5 * wheel.diameter});
  forces.resistance = CompactionResistance(soil, wheel.width, forces.sinkage);
  forces.shear_strength = area * soil.cohesion + wheel.load * std::tan(soil.friction_angle);
  return forces;
}

double ConeIndexFromBekker(const BekkerSoil& soil, double depth) {
  constexpr double kPound = 4.4482216;  // [N]
  constexpr double kConeHeight = 1.5;   // [in]
  const double n = soil.n, z = depth / Inches(1), tip = z + kConeHeight;
  const double kc = soil.kc / kPound * std::pow(Inches(1), n + 1);
  const double kphi = soil.kphi / kPound * std::pow(Inches(1), n + 2);
  const double cohesive = kc / (n + 1) * (std::pow(tip, n + 1) - std::pow(z, n + 1));
  const double frictional = 0.517 * kphi *
                            (std::pow(tip, n + 2) / ((n + 1) * (n + 2)) +
                             std::pow(z, n + 2) / (n + 2) - tip * std::pow(z, n + 1) / (n + 1));
  return Psi(1.625 * (cohesive + frictional));
}

double MeanConeIndexFromBekker(const BekkerSoil& soil) {
  double sum = 0;
  for (int inch = 0; inch <= 6; ++inch) sum += ConeIndexFromBekker(soil, Inches(inch));
  return sum / 7;
}

}  // namespace dbd
