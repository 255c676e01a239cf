#include <dbd/core/ride.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "support/core_printed.h"

namespace dbd {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kFeet = 1 / kFoot;

double Sine(double frequency, double t) { return std::sin(2 * std::numbers::pi * frequency * t); }

/// Gain of a filter at one frequency, from its coefficients.
template <int kOrder>
double GainOf(const LinearFilter<kOrder>& filter, double frequency, double step) {
  std::complex<double> numerator = 0, denominator = 0;
  for (int i = 0; i <= kOrder; ++i) {
    const auto delay =
        std::polar(1.0, -2 * std::numbers::pi * frequency * step * static_cast<double>(i));
    numerator += filter.b[i] * delay;
    denominator += filter.a[i] * delay;
  }
  return std::abs(numerator / denominator);
}

TEST(AbsorbedPowerGain, PrintedTable) {
  const struct {
    double frequency, gain, per_foot, per_metre, six_watts;
  } rows[] = {
      {1, 0.0880542, 0.00775354, 0.0834584, 8.47892}, {2, 0.195329, 0.0381535, 0.410681, 3.82229},
      {4, 0.442908, 0.196167, 2.11153, 1.68569},      {5, 0.442640, 0.195930, 2.10898, 1.68671},
      {8, 0.281314, 0.0791377, 0.851831, 2.65399},    {16, 0.139541, 0.0194717, 0.209592, 5.35043}};
  for (const auto& row : rows) {
    const double gain = AbsorbedPowerGain(row.frequency);
    ExpectPrinted(gain, row.per_metre);
    ExpectPrinted(gain * kFoot * kFoot, row.per_foot);
    ExpectPrinted(std::sqrt(gain) * kFoot, row.gain);
    ExpectPrinted(std::sqrt(6 / gain), row.six_watts);
  }
  ExpectPrinted(AbsorbedPowerGain(4.4635) * kFoot * kFoot, 0.208358);  // the peak
  EXPECT_LT(AbsorbedPowerGain(4.45), AbsorbedPowerGain(4.4635));
  EXPECT_LT(AbsorbedPowerGain(4.48), AbsorbedPowerGain(4.4635));
}

TEST(AbsorbedPowerFilter, PrintedCoefficientsAtOneMillisecond) {
  const LinearFilter<3> filter = AbsorbedPowerFilter(1e-3);
  const double b[] = {0.00709674, -0.0067912, -0.00709674, 0.0067912};
  const double a[] = {1, -2.91447, 2.83118, -0.916661};
  for (int i = 0; i < 4; ++i) {
    ExpectPrinted(filter.b[i], b[i], i % 2 == 0 ? 6 : 5);
    ExpectPrinted(filter.a[i], a[i]);
  }
  ExpectPrinted(GainOf(filter, 5, 1e-3), 0.442621);
}

TEST(AbsorbedPowerFilter, ControlStepKeepsTheGainWhereItMatters) {
  for (const double frequency : {1.0, 2.0, 4.0, 5.0, 8.0}) {
    const double gain = GainOf(AbsorbedPowerFilter(4e-3), frequency, 4e-3);
    EXPECT_NEAR(gain / (std::sqrt(AbsorbedPowerGain(frequency)) * kFoot), 1, 0.01) << frequency;
  }
}

TEST(AbsorbedPower, SineOfTheTabulatedSizeGivesSixWatts) {
  const std::pair<double, double> rows[] = {{1, 8.47892}, {2, 3.82229}, {4, 1.68569},
                                            {5, 1.68671}, {8, 2.65399}, {16, 5.35043}};
  const double step = 1e-3;
  for (const auto& [frequency, rms] : rows) {
    AbsorbedPower power(step);
    for (int i = 0; i < 15000; ++i) {
      power.Update(std::numbers::sqrt2 * rms * Sine(frequency, i * step));
    }
    // The window holds whole periods; what is left is the bilinear filter's own gain.
    const double digital = std::pow(kFeet * GainOf(AbsorbedPowerFilter(step), frequency, step), 2);
    EXPECT_NEAR(power.mean(), 6 * digital / AbsorbedPowerGain(frequency), 1e-4) << frequency;
    EXPECT_NEAR(power.mean(), 6, 2e-3 * 6) << frequency;
  }
}

TEST(AbsorbedPower, WindowSlidesWithoutSteps) {
  // A steady sine: the mean over ten seconds ending anywhere is the same to the size of one period.
  const double step = 1e-3;
  AbsorbedPower power(step);
  for (int i = 0; i < 15000; ++i) power.Update(2.38390 * Sine(4, i * step));  // 1.68569 rms: 6 W
  for (int i = 15000; i < 15300; ++i) {
    power.Update(2.38390 * Sine(4, i * step));
    ASSERT_NEAR(power.mean(), 6, 0.03) << i;
  }
}

TEST(AbsorbedPower, ForgetsAfterTenSeconds) {
  const double step = 4e-3;
  AbsorbedPower power(step);
  for (int i = 0; i < 1250; ++i) power.Update(2 * Sine(4, i * step));  // 5 s of 2.5 W
  // 2 m/s^2 amplitude is 2 in mean square, times 2.11 W/(m/s^2)^2, for half of the window; 1 % less
  // at this sampling rate, and the filter takes about 0.1 s to get going.
  EXPECT_NEAR(power.mean(), 0.5 * 2 * 2.11 * 0.98, 0.02);
  // The filter itself rings on with e^(-12 t): nearly a second later nothing is left in the window.
  for (int i = 0; i < 2725; ++i) power.Update(0);
  EXPECT_NEAR(power.mean(), 0, 1e-9);
}

TEST(AbsorbedPower, SteadyAccelerationAbsorbsNothing) {
  AbsorbedPower power(4e-3);
  for (int i = 0; i < 6000; ++i) power.Update(3);
  EXPECT_NEAR(power.mean(), 0, 1e-6);
}

double LowPassGain(double frequency, double step) {
  ButterworthLowPass filter(30, step);
  double peak = 0;
  for (int i = 0; i < 20000; ++i) {
    const double output = filter.Update(Sine(frequency, i * step));
    if (i > 4000) peak = std::max(peak, std::abs(output));
  }
  return peak;
}

TEST(ButterworthLowPass, FourthOrderMagnitude) {
  for (const double step : {1e-3, 4e-3}) {
    EXPECT_NEAR(LowPassGain(0.1, step), 1, 1e-4);
    EXPECT_NEAR(LowPassGain(30.01, step), std::numbers::sqrt2 / 2, 0.005);
  }
  // 1/sqrt(1 + 2^8) an octave above; the bilinear transform makes it a little steeper.
  EXPECT_NEAR(LowPassGain(60.01, 1e-3), 0.0624, 0.004);
}

TEST(RideMeter, ManyAtOnceCountAsOneByOne) {
  const double step = 4e-3;
  RideMeter one_by_one(step), at_once(step);
  std::vector<double> block;
  for (int i = 0; i < 6000; ++i) {
    const double acceleration = 3 * Sine(4, i * step) + Sine(0.7, i * step);
    block.push_back(acceleration);
    const double smooth = std::sqrt(one_by_one.Update(acceleration));
    if (i % 7 != 0) continue;
    EXPECT_GE(at_once.Update(block), smooth * smooth * (1 - 1e-12));
    EXPECT_EQ(at_once.absorbed_power(), one_by_one.absorbed_power());
    EXPECT_EQ(at_once.TakePeak(), one_by_one.TakePeak());
    block.clear();
  }
}

TEST(RideMeter, PeakIsTakenOnce) {
  RideMeter meter(4e-3);
  for (int i = 0; i < 500; ++i) meter.Update(-20);
  EXPECT_NEAR(meter.TakePeak(), 20, 3);  // with the overshoot of the filter
  for (int i = 0; i < 500; ++i) meter.Update(-20);
  EXPECT_NEAR(meter.TakePeak(), 20, 0.01);
  EXPECT_EQ(meter.TakePeak(), 0);
}

}  // namespace
}  // namespace dbd
