#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>

namespace dbd {

// The arithmetic that the engine is written in. A `Real` is a number or a pack of numbers, one per
// vehicle, with the usual operators and the functions below; comparisons give a mask, and `Select`
// takes the place of a branch, so that one source serves one vehicle or many.

template <class Real>
struct LaneTraits {
  static_assert(std::floating_point<Real>);
  using Scalar = Real;
  static constexpr int kLanes = 1;
  static Real Load(const Scalar* values) { return *values; }
  static void Store(Real value, Scalar* values) { *values = value; }
};

template <class Real>
using ScalarOf = typename LaneTraits<Real>::Scalar;

/// A number of the model, for all lanes: one that they share, or a pack with one for each.
template <class Real, class Number>
Real ToLanes(const Number& number) {
  if constexpr (std::is_arithmetic_v<Number>) {
    return Real(static_cast<ScalarOf<Real>>(number));
  } else {
    return number;
  }
}

/// The number of one lane.
template <std::floating_point T>
T NumberOf(T number, int /*lane*/) {
  return number;
}

/// Puts a number into one lane.
template <std::floating_point T>
void SetNumber(T& number, int /*lane*/, double value) {
  number = static_cast<T>(value);
}

template <std::floating_point T>
T Select(bool mask, T yes, T no) {
  return mask ? yes : no;
}
template <std::floating_point T>
T Min(T a, T b) {
  return a < b ? a : b;
}
template <std::floating_point T>
T Max(T a, T b) {
  return a < b ? b : a;
}
template <std::floating_point T>
T Abs(T a) {
  return std::abs(a);
}
template <std::floating_point T>
T Sqrt(T a) {
  return std::sqrt(a);
}
template <std::floating_point T>
T Exp(T a) {
  return std::exp(a);
}
template <std::floating_point T>
T Cbrt(T a) {
  return std::cbrt(a);
}
inline bool AnyOf(bool mask) { return mask; }

/// Products of packs (pack.h) convert to the first two.
template <class Real>
Real Clamp(const std::type_identity_t<Real>& value, const std::type_identity_t<Real>& low,
           const Real& high) {
  return Min(Max(value, low), high);
}

}  // namespace dbd
