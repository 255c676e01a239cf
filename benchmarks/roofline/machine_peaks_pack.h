#pragma once

#include <utility>

#include "machine_peaks.h"
#include "pack.h"

namespace dbd {

/// What the compiler calculates with: a vector, or a number.
template <class P>
struct RegisterOf {
  using Type = typename P::Vector;
};
template <>
struct RegisterOf<double> {
  using Type = double;
};

/// Loops that keep one unit of the processor busy with packs, or with scalars (`P` = double). The
/// empty assembler statements keep values in registers and iterations apart.
template <class P>
class PeakMeter {
 public:
  static MachinePeaks Measure() {
    MachinePeaks peaks;
    peaks.simple = Rate([](V& value, std::size_t i, const V& scale, const V& term) {
      value = i % 2 ? value * scale : value + term;
    });
#if DBD_PACK_TARGET > 0
    peaks.fused = Rate([](V& value, std::size_t, const V& scale, const V& term) {
      value = MultiplyAdd(value, scale, term);
    });
#endif
    peaks.divide = Rate([](V& value, std::size_t, const V& scale, const V&) { value /= scale; });
    peaks.square_root =
        Rate([](V& value, std::size_t, const V&, const V&) { value = SquareRoot(value); });
    // 16 kB stay in the first level, 96 MB in no level.
    peaks.loads = LoadRate(16 << 10, 1000);
    peaks.memory_bytes = LoadRate(96 << 20, 1) * sizeof(V);
    return peaks;
  }

 private:
  using V = typename RegisterOf<P>::Type;
  using S = ScalarOf<P>;
  static constexpr int kLanes = LaneTraits<P>::kLanes;
  static constexpr std::size_t kChains = 12;  // more than latency times units; fits 16 registers
  static constexpr double kLeastTime = 4e-3;  // [s]

  static V All(double value) { return static_cast<S>(value) - V{}; }

#if DBD_PACK_TARGET > 0  // GCC's own macros do not follow a pragma
  static V MultiplyAdd(V a, V b, V c) {
#if DBD_PACK_TARGET == 512
    if constexpr (sizeof(V) == 64 && sizeof(S) == 4) return V(_mm512_fmadd_ps(a, b, c));
    if constexpr (sizeof(V) == 64 && sizeof(S) == 8) return V(_mm512_fmadd_pd(a, b, c));
#endif
    if constexpr (sizeof(V) == 32 && sizeof(S) == 4) return V(_mm256_fmadd_ps(a, b, c));
    if constexpr (sizeof(V) == 32 && sizeof(S) == 8) return V(_mm256_fmadd_pd(a, b, c));
    return a;
  }
#endif

  static V SquareRoot(V a) {
    if constexpr (kLanes == 1) {
      return std::sqrt(a);
    } else {
      return Sqrt(P(a)).v;
    }
  }

  [[gnu::always_inline]] static void Keep(V& value) { asm volatile("" : "+x"(value)); }

  /// One variable for each chain: an array would be kept in memory.
  template <class Operation, std::size_t... I, class... Chain>
  [[gnu::always_inline]] static void Repeat(int rounds, const Operation& operation,
                                            std::index_sequence<I...>, Chain... chains) {
    V scale = All(1.0000001), term = All(1e-9);
    Keep(scale), Keep(term);
#pragma GCC unroll 4  // jumps are rare: where one lies can halve the speed of decoding
    for (int i = 0; i < rounds; ++i) {
      ((operation(chains, I, scale, term), Keep(chains)), ...);
    }
  }

  /// Calls `operation` on independent chains of values; lanes per second.
  template <class Operation>
  [[gnu::flatten, gnu::noinline]] static double Rate(const Operation& operation) {
    constexpr int kRounds = 10000;
    const V x = All(1.5);
    double rounds = 0, seconds = 0;
    const double begin = ThreadSeconds();
    do {
      Repeat(kRounds, operation, std::make_index_sequence<kChains>(), x, x, x, x, x, x, x, x, x, x,
             x, x);
      rounds += kRounds;
      seconds = ThreadSeconds() - begin;
    } while (seconds < kLeastTime);
    return rounds * kChains * kLanes / seconds;
  }

  /// Load instructions per second over an array of so many bytes.
  [[gnu::flatten, gnu::noinline]] static double LoadRate(std::size_t bytes, int repeats) {
    const char* const first = ReadableBytes(bytes);
    double loads = 0, seconds = 0;
    const double begin = ThreadSeconds();
    do {
      for (int i = 0; i < repeats; ++i) {
        for (std::size_t at = 0; at < bytes; at += 32 * sizeof(V)) {
          LoadMany(reinterpret_cast<const V*>(first + at), std::make_index_sequence<32>());
        }
      }
      loads += static_cast<double>(bytes / sizeof(V)) * repeats;
      seconds = ThreadSeconds() - begin;
    } while (seconds < kLeastTime);
    return loads / seconds;
  }

  template <std::size_t... I>
  [[gnu::always_inline]] static void LoadMany(const V* place, std::index_sequence<I...>) {
    (LoadOne(place + I), ...);
  }
  [[gnu::always_inline]] static void LoadOne(const V* place) {
    V value = *place;
    asm volatile("" : : "x"(value));
  }
};

}  // namespace dbd
