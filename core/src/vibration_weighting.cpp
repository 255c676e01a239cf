#include <dbd/core/vibration_weighting.h>

#include <cmath>

namespace dbd {
namespace {

double Square(double x) { return x * x; }

/// Squared magnitude of 1 + p/(Q w0) + (p/w0)^2 at p = i w, x = w/w0.
double Section(double x, double quality) { return Square(1 - x * x) + Square(x / quality); }

/// Second-order Butterworth limits of the band, 0.4 Hz and 100 Hz.
double BandLimits(double f) {
  const double low = std::pow(f / 0.4, 4), high = std::pow(f / 100, 4);
  return std::sqrt(low / (1 + low) / (1 + high));
}

/// From acceleration to velocity above `corner`, Q = 0.63.
double Transition(double f, double corner) {
  const double x = f / corner;
  return std::sqrt((1 + x * x) / Section(x, 0.63));
}

}  // namespace

double VerticalWeighting(double frequency) {
  constexpr double kLower = 2.37, kUpper = 3.35, kQuality = 0.91;  // of the upward step
  const double step =
      std::sqrt(Section(frequency / kLower, kQuality) / Section(frequency / kUpper, kQuality)) *
      Square(kLower / kUpper);
  return BandLimits(frequency) * Transition(frequency, 12.5) * step;
}

double HorizontalWeighting(double frequency) {
  return BandLimits(frequency) * Transition(frequency, 2.0);
}

}  // namespace dbd
