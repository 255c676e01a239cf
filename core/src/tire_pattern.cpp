#include "tire_pattern.h"

#include <cmath>
#include <numbers>

namespace dbd {

TirePattern MakeTirePattern(const TireModel& tire) {
  TirePattern pattern;
  const double radius = tire.radius, half_span = tire.width / kTirePlanes;
  pattern.size = {radius,     half_span,      2 * half_span,
                  tire.width, tire.stiffness, 0.75 / (std::numbers::sqrt2 * radius * radius)};
  pattern.reach = radius + half_span;
  const double step = 2 * std::numbers::pi / tire.points;
  const int half = static_cast<int>(std::floor((0.5 * std::numbers::pi - 1e-9) / step));
  pattern.count = 2 * half + 1;
  for (int i = 0; i < pattern.count; ++i) {
    pattern.points[i].x = radius * std::sin((i - half) * step);
    pattern.points[i].z = -radius * std::cos((i - half) * step);
  }
  for (int i = 0; i + 1 < pattern.count; ++i) {
    TirePoint<double>& here = pattern.points[i];
    const TirePoint<double>& next = pattern.points[i + 1];
    const double mid_x = 0.5 * (here.x + next.x), chord = 0.5 * (here.z + next.z);
    const double circle = -std::sqrt(radius * radius - mid_x * mid_x);
    here.length = next.x - here.x;
    here.rise = next.z - here.z;
    here.by_length = 1 / here.length;
    here.bulge = 4 * (chord - circle);
    here.four_bulge = 4 * here.bulge;
    here.third_bulge = here.bulge / 3;
    here.half_by_bulge = 0.5 / here.bulge;
  }
  return pattern;
}

}  // namespace dbd
