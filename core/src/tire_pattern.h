#pragma once

#include <dbd/core/vehicle_model.h>

#include <array>

namespace dbd {

inline constexpr int kTirePlanes = 3;
inline constexpr int kMaxLowerPoints = 33;  // of one plane, for 64 points round the circle

/// The lower points of one plane in the tire frame (x rolling direction, z up, origin at the hub)
/// and what is constant between neighbours.
struct TirePattern {
  double radius = 0;
  double half_span = 0;  // lateral distance of the outer planes from the middle one
  double reach = 0;      // from the hub, seen from above: no point is further away
  double width = 0;      // of the tire
  double stiffness = 0;
  int count = 0;  // odd; the middle point is the lowest
  std::array<double, kMaxLowerPoints> x{};
  std::array<double, kMaxLowerPoints> z{};
  // Of the segment from point i to i+1: four times the sagitta of the circle below its chord, and
  // quotients that the sums need.
  std::array<double, kMaxLowerPoints> bulge{};
  std::array<double, kMaxLowerPoints> half_by_bulge{};
  std::array<double, kMaxLowerPoints> length{};
  std::array<double, kMaxLowerPoints> by_length{};
};

TirePattern MakeTirePattern(const TireModel& tire);

}  // namespace dbd
