#include <dbd/core/roughness.h>

#include <cmath>
#include <numbers>

namespace dbd {
namespace {

constexpr double kReferenceWaveNumber = 0.1;  // [cycles/m]

double Square(double x) { return x * x; }

}  // namespace

double RoadSpectrum(RoadClass road) { return 16e-6 * std::pow(4.0, static_cast<int>(road)); }

double AngularRoadSpectrum(RoadClass road) {
  const double wave_number = 1 / (2 * std::numbers::pi);  // of 1 rad/m
  return RoadSpectrum(road) * Square(kReferenceWaveNumber / wave_number) * wave_number;
}

double RoadRms(RoadClass road, double longest, double shortest) {
  return std::sqrt(RoadSpectrum(road) * Square(kReferenceWaveNumber) * (longest - shortest));
}

}  // namespace dbd
