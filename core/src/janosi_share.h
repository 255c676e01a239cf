#pragma once

#include "scalar.h"

namespace dbd {

/// Share f(x) = 1 - (1 - e^(-x))/x of the shear strength in use, and its derivative.
template <class Real>
struct JanosiValue {
  Real share;
  Real slope;
};

/// For x >= 0; below 0.1 by its series, where the closed form cancels.
template <class Real>
JanosiValue<Real> JanosiShareOf(const Real& x) {
  using S = ScalarOf<Real>;
  const Real one(1);
  const Real least{S(0.1)};
  const auto small = x < least;
  const Real y = Max(x, least);
  const Real decay = Exp(Real(-1) * y);
  const Real closed = one - (one - decay) / y;
  const Real closed_slope = (one - decay * (one + y)) / (y * y);
  const auto c = [](double value) { return Real(S(value)); };
  const Real series =
      x *
      (c(1.0 / 2) - x * (c(1.0 / 6) - x * (c(1.0 / 24) - x * (c(1.0 / 120) - x * c(1.0 / 720)))));
  const Real series_slope =
      c(1.0 / 2) - x * (c(1.0 / 3) - x * (c(1.0 / 8) - x * (c(1.0 / 30) - x * c(1.0 / 144))));
  return {Select(small, series, closed), Select(small, series_slope, closed_slope)};
}

}  // namespace dbd
