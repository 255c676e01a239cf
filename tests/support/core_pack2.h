#pragma once

#include "scalar.h"

namespace dbd {

/// Two numbers side by side: the smallest lane type that the engine's templates can run on.
struct Mask2 {
  bool a, b;
};

struct Pack2 {
  Pack2() = default;
  explicit Pack2(double both) : a(both), b(both) {}
  Pack2(double first, double second) : a(first), b(second) {}

  double a, b;
};

template <>
struct LaneTraits<Pack2> {
  using Scalar = double;
  static constexpr int kLanes = 2;
  static Pack2 Load(const Scalar* values) { return {values[0], values[1]}; }
  static void Store(const Pack2& value, Scalar* values) {
    values[0] = value.a;
    values[1] = value.b;
  }
};

inline Pack2 operator+(const Pack2& x, const Pack2& y) { return {x.a + y.a, x.b + y.b}; }
inline Pack2 operator-(const Pack2& x, const Pack2& y) { return {x.a - y.a, x.b - y.b}; }
inline Pack2 operator*(const Pack2& x, const Pack2& y) { return {x.a * y.a, x.b * y.b}; }
inline Pack2 operator/(const Pack2& x, const Pack2& y) { return {x.a / y.a, x.b / y.b}; }
inline Pack2& operator+=(Pack2& x, const Pack2& y) { return x = x + y; }
inline Pack2& operator-=(Pack2& x, const Pack2& y) { return x = x - y; }
inline Mask2 operator<(const Pack2& x, const Pack2& y) { return {x.a < y.a, x.b < y.b}; }
inline Mask2 operator>(const Pack2& x, const Pack2& y) { return y < x; }

inline Pack2 Select(const Mask2& mask, const Pack2& yes, const Pack2& no) {
  return {mask.a ? yes.a : no.a, mask.b ? yes.b : no.b};
}
inline bool AnyOf(const Mask2& mask) { return mask.a || mask.b; }
inline Pack2 Min(const Pack2& x, const Pack2& y) { return {Min(x.a, y.a), Min(x.b, y.b)}; }
inline Pack2 Max(const Pack2& x, const Pack2& y) { return {Max(x.a, y.a), Max(x.b, y.b)}; }
inline Pack2 Abs(const Pack2& x) { return {Abs(x.a), Abs(x.b)}; }
inline Pack2 Sqrt(const Pack2& x) { return {Sqrt(x.a), Sqrt(x.b)}; }
inline Pack2 Exp(const Pack2& x) { return {Exp(x.a), Exp(x.b)}; }
inline Pack2 Cbrt(const Pack2& x) { return {Cbrt(x.a), Cbrt(x.b)}; }
inline double LeastLane(const Pack2& x) { return Min(x.a, x.b); }
inline double GreatestLane(const Pack2& x) { return Max(x.a, x.b); }

}  // namespace dbd
