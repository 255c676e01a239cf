#pragma once

#include <array>
#include <span>

namespace dbd {

// Ride and shock from vertical acceleration, sample by sample and without allocation.

/// A digital filter by the bilinear transform of an analogue one.
template <int kOrder>
struct LinearFilter {
  std::array<double, kOrder + 1> b{};  ///< numerator, newest first
  std::array<double, kOrder + 1> a{};  ///< denominator, a[0] = 1
  std::array<double, kOrder> memory{};

  double Update(double input) {
    const double output = b[0] * input + memory[0];
    for (int i = 0; i + 1 < kOrder; ++i) {
      memory[i] = memory[i + 1] + b[i + 1] * input - a[i + 1] * output;
    }
    memory[kOrder - 1] = b[kOrder] * input - a[kOrder] * output;
    return output;
  }
};

/// The human response filter of absorbed power, from acceleration in ft/s^2 to sqrt(W):
/// H(s) = 14.5 s (s + 44) / ((s + 63)(s^2 + 24 s + 750)); power = mean of (H a)^2. Derived from
/// published digital coefficients. `step`: sampling period [s].
LinearFilter<3> AbsorbedPowerFilter(double step);

/// |H|^2 of the analogue filter at `frequency` [Hz], in W/(m/s^2)^2.
double AbsorbedPowerGain(double frequency);

/// Absorbed power of one sample stream [W], as the mean over the last 10 s; time before the first
/// sample counts as standing still. Ten seconds are a few dozen metres: long enough that a single
/// bump, which is the shock limit's matter, does not count as a rough ride.
class AbsorbedPower {
 public:
  static constexpr double kWindow = 10.0;  // [s]

  explicit AbsorbedPower(double step);
  /// `accelerations`: vertical, without gravity [m/s^2].
  void Update(std::span<const double> accelerations);
  void Update(double acceleration) { Update(std::span(&acceleration, 1)); }
  /// Over the last `kWindow`, in whole bins of samples but for the oldest, of which the share that
  /// is still inside counts; what has not been driven counts as still.
  double mean() const;

 private:
  static constexpr int kBins = 100;  // of the window

  void BeginBin();

  LinearFilter<3> filter_;
  int samples_per_bin_;
  int samples_ = 0;  // in the newest bin
  int newest_ = 0;
  std::array<double, kBins + 1> sums_{};  // of squares of the filter's output [W]
  double complete_ = 0;                   // sum of all bins but the newest
};

/// Fourth-order Butterworth low-pass as two second-order sections: what peak vertical acceleration
/// is read behind (30 Hz). `cutoff` below half the sampling rate.
class ButterworthLowPass {
 public:
  ButterworthLowPass(double cutoff, double step);
  double Update(double input) { return second_.Update(first_.Update(input)); }

 private:
  LinearFilter<2> first_;
  LinearFilter<2> second_;
};

/// Both measures of one drive, fed with every control step: some at once keep the filters in
/// registers.
class RideMeter {
 public:
  static constexpr double kShockCutoff = 30.0;  // [Hz]

  explicit RideMeter(double step) : power_(step), low_pass_(kShockCutoff, step) {}

  /// Returns the sum of squares of the accelerations behind the low-pass.
  double Update(std::span<const double> vertical_accelerations);
  double Update(double vertical_acceleration) {
    return Update(std::span(&vertical_acceleration, 1));
  }
  double absorbed_power() const { return power_.mean(); }

  /// Largest magnitude behind the low-pass since the last call [m/s^2].
  double TakePeak();

 private:
  AbsorbedPower power_;
  ButterworthLowPass low_pass_;
  double peak_ = 0;
};

}  // namespace dbd
