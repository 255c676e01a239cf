#include <dbd/core/error.h>
#include <dbd/core/spectrum.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace dbd {

std::vector<SpectrumLine> AmplitudeSpectrum(const std::vector<double>& samples, double step) {
  const std::size_t n = samples.size();
  if (n < 8) throw InputError("a spectrum needs at least 8 samples");
  if (!(step > 0)) throw InputError("a spectrum needs a sampling step greater than 0");
  const double count = static_cast<double>(n);
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / count;
  std::vector<double> windowed(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(i) / count;
    windowed[i] = (samples[i] - mean) * (0.5 - 0.5 * std::cos(phase));
  }
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double>().fwd(transform, windowed);
  std::vector<SpectrumLine> lines(n / 2 + 1);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // The window halves a sine, and the other half of the spectrum holds as much again.
    lines[i] = {static_cast<double>(i) / (count * step), 4 * std::abs(transform[i]) / count};
  }
  return lines;
}

std::vector<double> SecondDerivative(const std::vector<double>& samples, double step) {
  std::vector<double> result;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    result.push_back((samples[i + 1] - 2 * samples[i] + samples[i - 1]) / (step * step));
  }
  return result;
}

}  // namespace dbd
