#pragma once

#include <dbd/core/vehicle_model.h>

#include <array>

namespace dbd {

inline constexpr int kTirePlanes = 3;
inline constexpr int kMaxLowerPoints = 33;  // of one plane, for 64 points round the circle

/// What is constant for a tire. Structs of nothing but numbers, of any kind: doubles as made, what
/// lanes compute with, or a number for each lane.
template <class Number>
struct TireSizes {
  Number radius;
  Number half_span;  // lateral distance of the outer planes from the middle one
  Number span;
  Number width;  // of the tire
  Number stiffness;
  Number by_flat_area;  // 0.75 / (sqrt 2 radius^2), see EquivalentDeflection
};

/// A lower point of one plane in the tire frame (x rolling direction, z up, origin at the hub), and
/// the segment from there to the next point.
template <class Number>
struct TirePoint {
  Number x, z;
  Number length, rise;  // to the next point, along x and z
  Number by_length;
  Number bulge;  // four times the sagitta of the circle below its chord
  Number four_bulge, third_bulge, half_by_bulge;
};

template <class Number>
struct TirePatternOf {
  TireSizes<Number> size;
  double reach = 0;  // from the hub, seen from above: no point is further away
  int count = 0;     // odd; the middle point is the lowest
  std::array<TirePoint<Number>, kMaxLowerPoints> points{};
};

using TirePattern = TirePatternOf<double>;

TirePattern MakeTirePattern(const TireModel& tire);

}  // namespace dbd
