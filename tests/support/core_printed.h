#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace dbd {

/// Agreement with a number that was printed with `digits` significant digits.
inline void ExpectPrinted(double actual, double printed, int digits = 6) {
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(printed))) - (digits - 1));
  EXPECT_NEAR(actual, printed, 0.501 * unit);
}

}  // namespace dbd
