#include "tire_pattern.h"

#include <cmath>
#include <numbers>

namespace dbd {

TirePattern MakeTirePattern(const TireModel& tire) {
  TirePattern pattern;
  pattern.radius = tire.radius;
  pattern.half_span = tire.width / kTirePlanes;
  pattern.reach = pattern.radius + pattern.half_span;
  pattern.width = tire.width;
  pattern.stiffness = tire.stiffness;
  const double step = 2 * std::numbers::pi / tire.points;
  const int half = static_cast<int>(std::floor((0.5 * std::numbers::pi - 1e-9) / step));
  pattern.count = 2 * half + 1;
  for (int i = 0; i < pattern.count; ++i) {
    pattern.x[i] = tire.radius * std::sin((i - half) * step);
    pattern.z[i] = -tire.radius * std::cos((i - half) * step);
  }
  for (int i = 0; i + 1 < pattern.count; ++i) {
    const double mid_x = 0.5 * (pattern.x[i] + pattern.x[i + 1]);
    const double chord = 0.5 * (pattern.z[i] + pattern.z[i + 1]);
    const double circle = -std::sqrt(tire.radius * tire.radius - mid_x * mid_x);
    pattern.bulge[i] = 4 * (chord - circle);
    pattern.half_by_bulge[i] = 0.5 / pattern.bulge[i];
    pattern.length[i] = pattern.x[i + 1] - pattern.x[i];
    pattern.by_length[i] = 1 / pattern.length[i];
  }
  return pattern;
}

}  // namespace dbd
