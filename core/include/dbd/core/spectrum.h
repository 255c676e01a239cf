#pragma once

#include <vector>

namespace dbd {

/// One line of a one-sided amplitude spectrum.
struct SpectrumLine {
  double frequency = 0;  ///< [Hz]
  double amplitude = 0;  ///< of a sine at this frequency, in the unit of the samples
};

/// Amplitude spectrum of evenly spaced samples, mean taken off, Hann window: a sine whose period
/// fits the record shows its amplitude at its own line and half of it at both neighbours. Lines
/// from 0 to half of the sampling rate, 1 / (n step) apart. Throws InputError for less than 8
/// samples or a step that is not positive.
std::vector<SpectrumLine> AmplitudeSpectrum(const std::vector<double>& samples, double step);

/// Second derivative by central differences, two samples shorter than its argument.
std::vector<double> SecondDerivative(const std::vector<double>& samples, double step);

}  // namespace dbd
