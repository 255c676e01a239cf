#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "operation_counts.h"
#include "scalar.h"

namespace dbd {

/// Where operations of `Counted` go. One thread.
struct OperationTally {
  static inline OperationCounts* counts = nullptr;  // null: not counted
  /// Arrays of state and workspace: numbers there are loaded and stored.
  static inline std::vector<std::pair<const void*, const void*>> memory;

  static void Count(Operation operation) {
    if (counts) ++(*counts)[operation];
  }
  static bool InMemory(const void* address) {
    const std::less<const void*> before;
    return std::any_of(memory.begin(), memory.end(), [&](const auto& range) {
      return !before(address, range.first) && before(address, range.second);
    });
  }
  static void Read(const void* address) {
    if (counts && InMemory(address)) Count(Operation::kLoad);
  }
  static void Write(const void* address) {
    if (counts && InMemory(address)) Count(Operation::kStore);
  }
};

/// N numbers that count what is done with them, once for all: the engine's templates over this type
/// do for one vehicle (N = 1) or a pack what they do over `double` or `Pack`.
template <int N>
class Counted {
 public:
  Counted() = default;
  explicit Counted(double all) {
    v.fill(all);
    OperationTally::Count(Operation::kConstant);
  }
  explicit Counted(const std::array<double, N>& values) : v(values) {}
  Counted(const Counted& other) : v(other.v), product(other.product) {
    OperationTally::Read(&other);
  }
  Counted& operator=(const Counted& other) {
    OperationTally::Read(&other);
    OperationTally::Write(this);
    v = other.v;
    product = other.product;
    return *this;
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }

  std::array<double, N> v{};
  mutable bool product = false;  // not yet part of a fused multiply-add
};

template <int N>
struct CountedMask {
  std::array<bool, N> v{};
};

template <int N>
struct LaneTraits<Counted<N>> {
  using Scalar = double;
  static constexpr int kLanes = N;
  static Counted<N> Load(const double* values) {
    Counted<N> pack;
    std::copy_n(values, N, pack.v.begin());
    return pack;
  }
  static void Store(const Counted<N>& pack, double* values) {
    std::copy_n(pack.v.begin(), N, values);
  }
};

namespace counted_detail {

template <int N, class Function>
Counted<N> Apply(Operation operation, const Counted<N>& a, Function function) {
  OperationTally::Count(operation);
  OperationTally::Read(&a);
  Counted<N> result;
  for (int i = 0; i < N; ++i) result.v[i] = function(a.v[i]);
  return result;
}

template <int N, class Function>
Counted<N> Apply(Operation operation, const Counted<N>& a, const Counted<N>& b, Function function) {
  OperationTally::Count(operation);
  OperationTally::Read(&a);
  OperationTally::Read(&b);
  Counted<N> result;
  for (int i = 0; i < N; ++i) result.v[i] = function(a.v[i], b.v[i]);
  return result;
}

/// An addition can take one product along.
template <int N>
void Fuse(const Counted<N>& a, const Counted<N>& b) {
  if (!a.product && !b.product) return;
  OperationTally::Count(Operation::kFused);
  (a.product ? a : b).product = false;
}

template <int N, class Function>
CountedMask<N> Compare(const Counted<N>& a, const Counted<N>& b, Function function) {
  OperationTally::Count(Operation::kCompare);
  OperationTally::Read(&a);
  OperationTally::Read(&b);
  CountedMask<N> mask;
  for (int i = 0; i < N; ++i) mask.v[i] = function(a.v[i], b.v[i]);
  return mask;
}

}  // namespace counted_detail

template <int N>
Counted<N> operator+(const Counted<N>& a, const Counted<N>& b) {
  counted_detail::Fuse(a, b);
  return counted_detail::Apply(Operation::kAdd, a, b, std::plus<double>());
}
template <int N>
Counted<N> operator-(const Counted<N>& a, const Counted<N>& b) {
  counted_detail::Fuse(a, b);
  return counted_detail::Apply(Operation::kAdd, a, b, std::minus<double>());
}
template <int N>
Counted<N> operator*(const Counted<N>& a, const Counted<N>& b) {
  Counted<N> result = counted_detail::Apply(Operation::kMultiply, a, b, std::multiplies<double>());
  result.product = true;
  return result;
}
template <int N>
Counted<N> operator/(const Counted<N>& a, const Counted<N>& b) {
  return counted_detail::Apply(Operation::kDivide, a, b, std::divides<double>());
}
template <int N>
CountedMask<N> operator<(const Counted<N>& a, const Counted<N>& b) {
  return counted_detail::Compare(a, b, std::less<double>());
}
template <int N>
CountedMask<N> operator>(const Counted<N>& a, const Counted<N>& b) {
  return counted_detail::Compare(a, b, std::greater<double>());
}

template <int N>
Counted<N> Select(const CountedMask<N>& mask, const Counted<N>& yes, const Counted<N>& no) {
  OperationTally::Count(Operation::kSelect);
  OperationTally::Read(&yes);
  OperationTally::Read(&no);
  Counted<N> result;
  for (int i = 0; i < N; ++i) result.v[i] = mask.v[i] ? yes.v[i] : no.v[i];
  return result;
}
template <int N>
Counted<N> Min(const Counted<N>& a, const Counted<N>& b) {
  return counted_detail::Apply(Operation::kExtreme, a, b,
                               [](double x, double y) { return Min(x, y); });
}
template <int N>
Counted<N> Max(const Counted<N>& a, const Counted<N>& b) {
  return counted_detail::Apply(Operation::kExtreme, a, b,
                               [](double x, double y) { return Max(x, y); });
}
template <int N>
Counted<N> Abs(const Counted<N>& a) {
  return counted_detail::Apply(Operation::kAbsolute, a, [](double x) { return std::abs(x); });
}
template <int N>
Counted<N> Sqrt(const Counted<N>& a) {
  return counted_detail::Apply(Operation::kSquareRoot, a, [](double x) { return std::sqrt(x); });
}
template <int N>
Counted<N> Exp(const Counted<N>& a) {
  return counted_detail::Apply(Operation::kExponential, a, [](double x) { return std::exp(x); });
}
template <int N>
Counted<N> Cbrt(const Counted<N>& a) {
  return counted_detail::Apply(Operation::kCubeRoot, a, [](double x) { return std::cbrt(x); });
}
template <int N>
bool AnyOf(const CountedMask<N>& mask) {
  return std::any_of(mask.v.begin(), mask.v.end(), [](bool lane) { return lane; });
}

/// The whole numbers below; there and back.
template <int N>
Counted<N> Truncated(const Counted<N>& a) {
  OperationTally::Count(Operation::kConvert);
  return counted_detail::Apply(Operation::kConvert, a, [](double x) { return std::trunc(x); });
}

}  // namespace dbd
