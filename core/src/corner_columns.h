#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "pack.h"

namespace dbd {

// Four floats for each lane, side by side in memory at places of their own, as four packs: one
// 16-byte read per lane and a transposition, which takes a third of the instructions of reading
// number by number and half the time of the processor's gather.

template <int N>
struct CornerColumns {
  Pack<float, N> south_west, north_west, south_east, north_east;
};

namespace corner_detail {

template <int N>
using Floats = Pack<float, N>;
template <int N>
using Order = typename Pack<float, N>::Integers;

template <int N>
Floats<2 * N> Join(const Floats<N>& a, const Floats<N>& b) {
  if constexpr (N == 4) {
    return Floats<8>(__builtin_shufflevector(a.v, b.v, 0, 1, 2, 3, 4, 5, 6, 7));
  } else {
    return Floats<16>(
        __builtin_shufflevector(a.v, b.v, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  }
}

/// The indices as numbers in memory, from where they become addresses in one instruction each;
/// left to itself, GCC takes them out of the register one by one, in three.
template <int N>
struct alignas(N * sizeof(std::int32_t)) Indices {
  explicit Indices(const Order<N>& index) {
    std::memcpy(number, &index, sizeof(number));
    asm volatile("" : "+m"(number));
  }
  std::int32_t number[N];
};

/// The four floats of every fourth lane from `lane` on, one after the other.
template <int N>
Floats<N> EveryFourth(const float* pairs, const Indices<N>& index, int lane) {
  const auto read = [&](int i) {
    Floats<4> four;
    std::memcpy(&four.v, pairs + 2 * static_cast<std::int64_t>(index.number[i]), sizeof(four.v));
    return four;
  };
  if constexpr (N == 4) {
    return read(lane);
  } else if constexpr (N == 8) {
    return Join<4>(read(lane), read(lane + 4));
  } else {
#if DBD_PACK_TARGET >= 512
    __m512 four = _mm512_castps128_ps512(read(lane).v);
    four = _mm512_insertf32x4(four, read(lane + 4).v, 1);
    four = _mm512_insertf32x4(four, read(lane + 8).v, 2);
    return Floats<16>(_mm512_insertf32x4(four, read(lane + 12).v, 3));
#else
    return Join<8>(Join<4>(read(lane), read(lane + 4)), Join<4>(read(lane + 8), read(lane + 12)));
#endif
  }
}

/// From each block of four of `a` and `b` the numbers at `first` and `second`, taken in turns of
/// `run`: what the unpack instructions do.
template <int N>
Floats<N> Interleave(const Floats<N>& a, const Floats<N>& b, int begin, int run) {
  Order<N> order{};
  for (int i = 0; i < N; ++i) {
    const int in_block = i % 4, pair = in_block / (2 * run), from_b = in_block / run % 2;
    order[i] = i - in_block + begin + pair + in_block % run + from_b * N;
  }
  return Floats<N>(__builtin_shuffle(a.v, b.v, order));
}

}  // namespace corner_detail

/// Column k holds number k of every lane; lane i reads four floats at pairs + 2 lane_index[i].
template <int N>
CornerColumns<N> ReadCornerColumns(const float* pairs,
                                   const typename Pack<float, N>::Integers& lane_index) {
  using namespace corner_detail;
  const Indices<N> index(lane_index);
  const Floats<N> w0 = EveryFourth<N>(pairs, index, 0), w1 = EveryFourth<N>(pairs, index, 1);
  const Floats<N> w2 = EveryFourth<N>(pairs, index, 2), w3 = EveryFourth<N>(pairs, index, 3);
  const Floats<N> low01 = Interleave<N>(w0, w1, 0, 1), low23 = Interleave<N>(w2, w3, 0, 1);
  const Floats<N> high01 = Interleave<N>(w0, w1, 2, 1), high23 = Interleave<N>(w2, w3, 2, 1);
  return {Interleave<N>(low01, low23, 0, 2), Interleave<N>(low01, low23, 2, 2),
          Interleave<N>(high01, high23, 0, 2), Interleave<N>(high01, high23, 2, 2)};
}

}  // namespace dbd
