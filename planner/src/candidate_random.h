#pragma once

#include <cstdint>

namespace dbd {

/// SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators",
/// 2014): the same numbers from every compiler and library.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// In [0, 1).
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t state_;
};

/// A seed of its own for each (seed, stream).
inline std::uint64_t DeriveSeed(std::uint64_t seed, std::uint64_t stream) {
  SplitMix64 outer(seed);
  SplitMix64 inner(outer.Next() ^ (stream * 0xd1342543de82ef95ULL));
  return inner.Next();
}

}  // namespace dbd
