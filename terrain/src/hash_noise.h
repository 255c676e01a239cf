#pragma once

#include <cstdint>

namespace dbd {

/// Random numbers from places instead of from a sequence: the same on every machine, in any order.
class HashNoise {
 public:
  explicit HashNoise(std::uint64_t seed) : seed_(seed) {}

  /// Uniform in [0, 1) for a lattice point; `channel` tells independent numbers apart.
  double Uniform(std::int64_t i, std::int64_t j, int channel) const;

  /// Gradient noise (Perlin 1985, quintic fade of 2002) with lattice spacing 1: smooth, zero at
  /// lattice points, about -0.7 to 0.7.
  double Gradient(double x, double y, int channel) const;

  /// Octaves of gradient noise, each at half the wavelength and `gain` times the height of the
  /// one before.
  double Fractal(double x, double y, int octaves, double gain, int channel) const;

 private:
  std::uint64_t seed_;
};

}  // namespace dbd
