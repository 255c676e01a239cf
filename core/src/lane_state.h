#pragma once

#include <cstring>

#include "engine_state.h"
#include "pack.h"

namespace dbd {

// Structs of the engine's state hold nothing but `Real`s, so that a lane of a struct over packs is
// the same struct over numbers, number by number.

template <class Real, template <class> class Struct>
void SetLaneOf(Struct<Real>& pack, int lane, const Struct<double>& values) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  constexpr std::size_t kNumbers = sizeof(Struct<double>) / sizeof(double);
  static_assert(sizeof(Struct<Real>) == kNumbers * sizeof(Real));
  double numbers[kNumbers];
  std::memcpy(numbers, &values, sizeof(values));
  auto* bytes = reinterpret_cast<unsigned char*>(&pack);
  for (std::size_t k = 0; k < kNumbers; ++k) {
    const S value = static_cast<S>(numbers[k]);
    std::memcpy(bytes + (k * kLanes + static_cast<std::size_t>(lane)) * sizeof(S), &value,
                sizeof(S));
  }
}

template <class Real, template <class> class Struct>
Struct<double> LaneOf(const Struct<Real>& pack, int lane) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  constexpr std::size_t kNumbers = sizeof(Struct<double>) / sizeof(double);
  static_assert(sizeof(Struct<Real>) == kNumbers * sizeof(Real));
  double numbers[kNumbers];
  const auto* bytes = reinterpret_cast<const unsigned char*>(&pack);
  for (std::size_t k = 0; k < kNumbers; ++k) {
    S value;
    std::memcpy(&value, bytes + (k * kLanes + static_cast<std::size_t>(lane)) * sizeof(S),
                sizeof(S));
    numbers[k] = static_cast<double>(value);
  }
  Struct<double> values;
  std::memcpy(&values, numbers, sizeof(values));
  return values;
}

/// The same numbers of another type.
template <class To, template <class> class Struct>
Struct<To> NumbersAs(const Struct<double>& values) {
  constexpr std::size_t kNumbers = sizeof(Struct<double>) / sizeof(double);
  static_assert(sizeof(Struct<To>) == kNumbers * sizeof(To));
  double numbers[kNumbers];
  std::memcpy(numbers, &values, sizeof(values));
  To converted[kNumbers];
  for (std::size_t k = 0; k < kNumbers; ++k) converted[k] = static_cast<To>(numbers[k]);
  Struct<To> result;
  std::memcpy(&result, converted, sizeof(result));
  return result;
}

}  // namespace dbd
