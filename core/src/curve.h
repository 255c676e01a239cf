#pragma once

#include <dbd/core/vehicle_model.h>

#include "scalar.h"

namespace dbd {

/// The polygon through strictly rising points (x, y). Throws InputError that says what is wrong
/// with them when there are fewer than two, or either column does not rise.
CurveModel MakeCurve(const std::vector<double>& x, const std::vector<double>& y);

template <class Real>
Real EvaluateCurve(const CurveModel& curve, const Real& x) {
  using S = ScalarOf<Real>;
  Real sum = Real(S(curve.value)) + Real(S(curve.slope)) * (x - Real(S(curve.origin)));
  for (const CurveModel::Hinge& hinge : curve.hinges) {
    sum = sum + Real(S(hinge.slope_change)) * Max(x - Real(S(hinge.at)), Real(0));
  }
  return sum;
}

/// The x at which a rising curve has the value y.
double InvertCurve(const CurveModel& curve, double y);

/// Its steepest slope: what decides the critical time step.
double SteepestSlope(const CurveModel& curve);

}  // namespace dbd
