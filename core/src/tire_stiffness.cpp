#include <dbd/core/tire_stiffness.h>

#include <algorithm>
#include <cmath>

namespace dbd {

double LoadRatingStiffness(double rated_load, double section_height) {
  return rated_load / (0.16 * section_height);
}

double TireDamping(double stiffness, double wheel_mass, double ratio) {
  return 2 * ratio * std::sqrt(stiffness * wheel_mass);
}

double ForestTireDeflection(double load, double pressure) {
  return 0.0008 + 0.001 * (0.365 + 170 / (pressure / 1e3)) * (load / 1e3);
}

double PressureLineStiffness(double pressure) { return pressure + 150000; }

double ProgressiveStiffness(double stiffness, double section_height, double deflection) {
  return stiffness * section_height / std::max(0.1 * section_height, section_height - deflection);
}

}  // namespace dbd
