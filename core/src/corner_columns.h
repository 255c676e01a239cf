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
using CornerColumns = std::array<Pack<float, N>, 4>;

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

/// The four floats of every fourth lane from `lane` on, one after the other.
template <int N>
Floats<N> EveryFourth(const float* pairs, const Order<N>& index, int lane) {
  const auto read = [&](int i) {
    Floats<4> four;
    std::memcpy(&four.v, pairs + 2 * static_cast<std::int64_t>(index[i]), sizeof(four.v));
    return four;
  };
  if constexpr (N == 4) {
    return read(lane);
  } else if constexpr (N == 8) {
    return Join<4>(read(lane), read(lane + 4));
  } else {
    return Join<8>(Join<4>(read(lane), read(lane + 4)), Join<4>(read(lane + 8), read(lane + 12)));
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

/// Column k holds number k of every lane; lane i reads four floats at pairs + 2 index[i].
template <int N>
CornerColumns<N> ReadCornerColumns(const float* pairs,
                                   const typename Pack<float, N>::Integers& index) {
  using namespace corner_detail;
  const Floats<N> w0 = EveryFourth<N>(pairs, index, 0), w1 = EveryFourth<N>(pairs, index, 1);
  const Floats<N> w2 = EveryFourth<N>(pairs, index, 2), w3 = EveryFourth<N>(pairs, index, 3);
  const Floats<N> low01 = Interleave<N>(w0, w1, 0, 1), low23 = Interleave<N>(w2, w3, 0, 1);
  const Floats<N> high01 = Interleave<N>(w0, w1, 2, 1), high23 = Interleave<N>(w2, w3, 2, 1);
  return {Interleave<N>(low01, low23, 0, 2), Interleave<N>(low01, low23, 2, 2),
          Interleave<N>(high01, high23, 0, 2), Interleave<N>(high01, high23, 2, 2)};
}

}  // namespace dbd
