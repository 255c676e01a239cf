#include "hash_noise.h"

#include <cmath>
#include <numbers>

namespace dbd {
namespace {

// Finalizer of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t Mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double Blend(double a, double b, double weight) { return a + weight * (b - a); }

}  // namespace

double HashNoise::Uniform(std::int64_t i, std::int64_t j, int channel) const {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  std::uint64_t hash = Mix(seed_ + kGolden * static_cast<std::uint64_t>(channel + 1));
  hash = Mix(hash + kGolden * static_cast<std::uint64_t>(i));
  hash = Mix(hash + kGolden * static_cast<std::uint64_t>(j));
  return static_cast<double>(hash >> 11) * 0x1.0p-53;
}

double HashNoise::Gradient(double x, double y, int channel) const {
  const double west = std::floor(x);
  const double south = std::floor(y);
  const auto corner = [&](int di, int dj) {
    const double angle = 2 * std::numbers::pi *
                         Uniform(static_cast<std::int64_t>(west) + di,
                                 static_cast<std::int64_t>(south) + dj, channel);
    return std::cos(angle) * (x - west - di) + std::sin(angle) * (y - south - dj);
  };
  const double u = Fade(x - west);
  const double v = Fade(y - south);
  return Blend(Blend(corner(0, 0), corner(1, 0), u), Blend(corner(0, 1), corner(1, 1), u), v);
}

double HashNoise::Fractal(double x, double y, int octaves, double gain, int channel) const {
  double sum = 0;
  double height = 1;
  double frequency = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * Gradient(x * frequency, y * frequency, channel + octave);
    height *= gain;
    frequency *= 2;
  }
  return sum;
}

}  // namespace dbd
