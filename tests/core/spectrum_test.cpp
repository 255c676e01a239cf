#include <dbd/core/spectrum.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

constexpr double kStep = 4e-3;  // 250 Hz

/// amplitude * sin(2 pi frequency t) + offset
std::vector<double> Sine(int count, double frequency, double amplitude, double offset = 0) {
  std::vector<double> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back(offset +
                      amplitude * std::sin(2 * std::numbers::pi * frequency * kStep * i + 0.3));
  }
  return samples;
}

// 1000 samples at 250 Hz last 4 s, so lines are 0.25 Hz apart: 6.5 Hz is line 26. Hann's window
// leaves the amplitude there, half of it at lines 25 and 27, nothing elsewhere.
TEST(AmplitudeSpectrum, ShowsASineAtItsLine) {
  const auto lines = AmplitudeSpectrum(Sine(1000, 6.5, 1.75, 9.81), kStep);
  ASSERT_EQ(lines.size(), 501u);
  EXPECT_DOUBLE_EQ(lines[26].frequency, 6.5);
  EXPECT_DOUBLE_EQ(lines.back().frequency, 125);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double expected = i == 26 ? 1.75 : i == 25 || i == 27 ? 0.875 : 0;
    EXPECT_NEAR(lines[i].amplitude, expected, 1e-12) << lines[i].frequency;
  }
}

TEST(AmplitudeSpectrum, TwoSinesOfAnOddRecordStaySeparate) {
  // 875 samples last 3.5 s: 2 Hz is line 7, 14 Hz is line 49.
  std::vector<double> samples = Sine(875, 2, 3);
  const std::vector<double> other = Sine(875, 14, 0.5);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += other[i];
  const auto lines = AmplitudeSpectrum(samples, kStep);
  EXPECT_NEAR(lines[7].amplitude, 3, 1e-12);
  EXPECT_NEAR(lines[49].amplitude, 0.5, 1e-12);
  EXPECT_NEAR(lines[30].amplitude, 0, 1e-12);
}

TEST(AmplitudeSpectrum, RefusesTooFewSamples) {
  EXPECT_EQ(InputErrorOf([] { AmplitudeSpectrum(std::vector<double>(7), kStep); }),
            "a spectrum needs at least 8 samples");
  EXPECT_EQ(InputErrorOf([] { AmplitudeSpectrum(std::vector<double>(8), 0); }),
            "a spectrum needs a sampling step greater than 0");
}

// Of t^2 exactly 2; of a sine -w^2 times it, up to (w h)^2 / 12.
TEST(SecondDerivative, OfAParabolaAndASine) {
  EXPECT_EQ(SecondDerivative({0, 1, 4, 9}, 1), (std::vector<double>{2, 2}));
  const std::vector<double> sine = Sine(100, 3, 1);
  const std::vector<double> second = SecondDerivative(sine, kStep);
  const double w = 2 * std::numbers::pi * 3;
  ASSERT_EQ(second.size(), 98u);
  EXPECT_NEAR(second[40], -w * w * sine[41], w * w * std::pow(w * kStep, 2) / 12 * 1.01);
}

}  // namespace
}  // namespace dbd
