#pragma once

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "scalar.h"

namespace dbd {

// Packs of numbers for the engine's templates, on the compiler's vector types: one source for every
// instruction set, and every lane goes through the same operations whatever the width. The compiler
// must not contract products and sums as it sees fit (see cmake/dbd_target.cmake): which are one
// operation is written in the types below. A vehicle therefore drives bit by bit the same in packs
// of 4, 8 or 16.

/// Which instruction set this translation unit compiles packs for. It is a part of their type: a
/// function over packs that is compiled in two translation units is then two functions, and the
/// linker cannot put the one for a wider processor in the place of the other.
/// (GCC 12 does not define __AVX__ and its like after its pragma for C++.)
#ifndef DBD_PACK_TARGET
#define DBD_PACK_TARGET 0
#endif

/// The integer as wide as a number.
template <class T>
using LaneInteger = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

// The alignment is written out: the compiler's own for wide vectors depends on the instruction set.
template <class T, int N, int kTarget = DBD_PACK_TARGET>
struct alignas(N * sizeof(T)) PackMask {
  typedef LaneInteger<T> Vector __attribute__((vector_size(N * sizeof(T))));
  Vector v;  // all bits set where true
};

/// One bit a lane, as AVX-512 has them.
template <class T, int N>
requires(N * sizeof(T) >= 32) struct PackMask<T, N, 512> {
  std::conditional_t<N == 16, std::uint16_t, std::uint8_t> bits;
};

/// a times b, not rounded yet: a sum takes both factors into one fused multiply-add, whoever else
/// uses it gets the number.
template <class P>
struct Product {
  typedef typename P::Vector Vector;
  Vector a, b;
  [[gnu::always_inline]] inline operator P() const { return P(a * b); }
};

template <class T, int N, int kTarget = DBD_PACK_TARGET>
struct alignas(N * sizeof(T)) Pack {
  typedef T Vector __attribute__((vector_size(N * sizeof(T))));
  typedef LaneInteger<T> Integers __attribute__((vector_size(N * sizeof(T))));
  /// Translation units for AVX2 are compiled for fused multiply-adds too.
  using Times = std::conditional_t<kTarget >= 2, Product<Pack>, Pack>;

  Pack() = default;
  explicit Pack(T all) : v(all - Vector{}) {}
  explicit Pack(const Vector& lanes) : v(lanes) {}

  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator+=(const Product<Pack>& b) { return *this = *this + b; }
  Pack& operator-=(const Product<Pack>& b) { return *this = *this - b; }

  // Friends, so that products convert to either side. Inlined always, and so before GCC takes
  // structs apart: left to its own it does that later, and keeps some products in memory.
  [[gnu::always_inline]] friend inline Pack operator+(const Pack& a, const Pack& b) {
    return Pack(a.v + b.v);
  }
  [[gnu::always_inline]] friend inline Pack operator-(const Pack& a, const Pack& b) {
    return Pack(a.v - b.v);
  }
  [[gnu::always_inline]] friend inline Pack operator/(const Pack& a, const Pack& b) {
    return Pack(a.v / b.v);
  }
  [[gnu::always_inline]] friend inline Pack operator-(const Pack& a) { return Pack(-a.v); }
  [[gnu::always_inline]] friend inline Times operator*(const Pack& a, const Pack& b) {
    if constexpr (kTarget >= 2) {
      return {a.v, b.v};
    } else {
      return Pack(a.v * b.v);
    }
  }

  // With a constant, for numbers of the model.
  [[gnu::always_inline]] friend inline Pack operator+(T a, const Pack& b) { return Pack(a) + b; }
  [[gnu::always_inline]] friend inline Pack operator-(T a, const Pack& b) { return Pack(a) - b; }
  [[gnu::always_inline]] friend inline Pack operator/(T a, const Pack& b) { return Pack(a) / b; }
  [[gnu::always_inline]] friend inline Pack operator/(const Pack& a, T b) { return a / Pack(b); }
  [[gnu::always_inline]] friend inline Times operator*(T a, const Pack& b) { return Pack(a) * b; }
  [[gnu::always_inline]] friend inline Times operator*(const Pack& a, T b) { return a * Pack(b); }

  [[gnu::always_inline]] friend inline Pack operator+(const Product<Pack>& p, const Pack& c) {
    return MultiplyAdd(Pack(p.a), Pack(p.b), c);
  }
  [[gnu::always_inline]] friend inline Pack operator+(const Pack& c, const Product<Pack>& p) {
    return MultiplyAdd(Pack(p.a), Pack(p.b), c);
  }
  [[gnu::always_inline]] friend inline Pack operator-(const Product<Pack>& p, const Pack& c) {
    return MultiplyAdd(Pack(p.a), Pack(p.b), -c);
  }
  [[gnu::always_inline]] friend inline Pack operator-(const Pack& c, const Product<Pack>& p) {
    return MultiplyAdd(Pack(-p.a), Pack(p.b), c);
  }
  [[gnu::always_inline]] friend inline Pack operator+(const Product<Pack>& p,
                                                      const Product<Pack>& q) {
    return p + Pack(q);
  }
  [[gnu::always_inline]] friend inline Pack operator-(const Product<Pack>& p,
                                                      const Product<Pack>& q) {
    return p - Pack(q);
  }

  Vector v;
};

template <class T, int N>
struct LaneTraits<Pack<T, N>> {
  using Scalar = T;
  static constexpr int kLanes = N;
  static Pack<T, N> Load(const T* values) {
    Pack<T, N> pack;
    std::memcpy(&pack.v, values, sizeof(pack.v));
    return pack;
  }
  static void Store(const Pack<T, N>& pack, T* values) {
    std::memcpy(values, &pack.v, sizeof(pack.v));
  }
};

template <class T, int N>
PackMask<T, N> operator<(const Pack<T, N>& a, const Pack<T, N>& b) {
  return {a.v < b.v};
}
template <class T, int N>
PackMask<T, N> operator>(const Pack<T, N>& a, const Pack<T, N>& b) {
  return {a.v > b.v};
}

template <class T, int N>
void SetNumber(Pack<T, N>& pack, int lane, double value) {
  pack.v[lane] = static_cast<T>(value);
}
template <class T, int N>
T NumberOf(const Pack<T, N>& pack, int lane) {
  return pack.v[lane];
}

template <class T, int N>
Pack<T, N> Select(const PackMask<T, N>& mask, const Pack<T, N>& yes, const Pack<T, N>& no) {
  return Pack<T, N>(mask.v ? yes.v : no.v);
}
template <class T, int N>
Pack<T, N> Min(const Pack<T, N>& a, const Pack<T, N>& b) {
  return Pack<T, N>(a.v < b.v ? a.v : b.v);
}
template <class T, int N>
Pack<T, N> Max(const Pack<T, N>& a, const Pack<T, N>& b) {
  return Pack<T, N>(a.v < b.v ? b.v : a.v);
}
template <class T, int N>
Pack<T, N> Abs(const Pack<T, N>& a) {
  constexpr auto kAllButSign = std::numeric_limits<LaneInteger<T>>::max();
  const auto bits = __builtin_bit_cast(typename Pack<T, N>::Integers, a.v) & kAllButSign;
  return Pack<T, N>(__builtin_bit_cast(typename Pack<T, N>::Vector, bits));
}
template <class T, int N>
Pack<T, N> Sqrt(const Pack<T, N>& a) {
  Pack<T, N> root;
  for (int i = 0; i < N; ++i) root.v[i] = std::sqrt(a.v[i]);
  return root;
}
template <class T, int N>
bool AnyOf(const PackMask<T, N>& mask) {
  constexpr std::size_t kBytes = N * sizeof(T);
  std::int64_t parts[kBytes / sizeof(std::int64_t)];
  std::memcpy(parts, &mask.v, kBytes);
  std::int64_t any = 0;
  for (const std::int64_t part : parts) any |= part;
  return any != 0;
}

namespace pack_detail {

template <class T>
inline constexpr int kMantissaBits = sizeof(T) == 4 ? 23 : 52;
template <class T>
inline constexpr int kExponentBias = sizeof(T) == 4 ? 127 : 1023;

/// ln 2 in two parts: the first has so few bits that its product with a whole number is exact.
template <class T>
inline constexpr T kLog2High = sizeof(T) == 4 ? T(0.693359375) : T(6.93147180369123816490e-01);
template <class T>
inline constexpr T kLog2Low = sizeof(T) == 4 ? T(-2.12194440e-4) : T(1.90821492927058770002e-10);

/// 1/k! for k = 2 ..., as many as |r| <= ln 2 / 2 needs for round-off.
template <class T>
inline constexpr int kExpTerms = sizeof(T) == 4 ? 6 : 12;

template <class P>
P InverseFactorial(int k) {
  double product = 1;
  for (int i = 2; i <= k; ++i) product *= i;
  return P(static_cast<ScalarOf<P>>(1 / product));
}

}  // namespace pack_detail

/// e^a = 2^n e^r with n whole and |r| <= ln 2 / 2, e^r by its series. Below the smallest normal
/// number the result stays at about that; the engine's arguments are 0 or negative.
template <class T, int N>
Pack<T, N> Exp(const Pack<T, N>& a) {
  using P = Pack<T, N>;
  using namespace pack_detail;
  const T most = sizeof(T) == 4 ? T(87) : T(708);
  const P x = Min(Max(a, P(-most)), P(most));
  // Adding 1.5 2^bits rounds to a whole number, which then stands in the low bits.
  const T magic = T(3ll << (kMantissaBits<T> - 1));
  const P shifted = x * P(T(1.4426950408889634)) + P(magic);
  const P n = shifted - P(magic);
  const P r = (x - n * P(kLog2High<T>)) - n * P(kLog2Low<T>);
  // Even and odd powers apart: half as many operations wait for each other.
  const P r2 = r * r;
  P even = InverseFactorial<P>(kExpTerms<T>), odd = InverseFactorial<P>(kExpTerms<T> - 1);
  for (int k = kExpTerms<T> - 2; k >= 2; k -= 2) even = even * r2 + InverseFactorial<P>(k);
  for (int k = kExpTerms<T> - 3; k >= 2; k -= 2) odd = odd * r2 + InverseFactorial<P>(k);
  const P value = P(T(1)) + (r + r2 * (even + r * odd));
  const auto whole = __builtin_bit_cast(typename P::Integers, shifted.v) -
                     __builtin_bit_cast(LaneInteger<T>, magic);
  const auto power = (whole + kExponentBias<T>) << kMantissaBits<T>;
  return value * P(__builtin_bit_cast(typename P::Vector, power));
}

/// For a >= 0: a third of the exponent as a first guess, then Halley's rule, which triples the
/// number of right digits each time.
template <class T, int N>
Pack<T, N> Cbrt(const Pack<T, N>& a) {
  using P = Pack<T, N>;
  using namespace pack_detail;
  constexpr LaneInteger<T> kOffset = (LaneInteger<T>(kExponentBias<T>) << kMantissaBits<T>) / 3 * 2;
  // Thirds by a product in the number's own arithmetic: whole vectors have no division.
  const auto bits = __builtin_bit_cast(typename P::Integers, a.v);
  const auto third = __builtin_convertvector(
      __builtin_convertvector(bits, typename P::Vector) * T(1.0 / 3), typename P::Integers);
  P x(__builtin_bit_cast(typename P::Vector, third + kOffset));
  for (int i = 0; i < (sizeof(T) == 4 ? 2 : 3); ++i) {
    const P cube = x * x * x;
    x = x * ((cube + a + a) / (cube + cube + a));
  }
  const P least(T(1e-30));
  return Select(a > least, x, P(T(0)));
}

template <class P>
P Exp(const Product<P>& p) {
  return Exp(P(p));
}

}  // namespace dbd

#include "pack_instructions.h"
