#pragma once

#include <dbd/core/vehicle_model.h>

#include "scalar.h"

namespace dbd {

/// The polygon through strictly rising points (x, y). Throws InputError that says what is wrong
/// with them when there are fewer than two, or either column does not rise.
CurveModel MakeCurve(const std::vector<double>& x, const std::vector<double>& y);

template <class Real, class Curve>
Real EvaluateCurve(const Curve& curve, const Real& x) {
  Real sum =
      ToLanes<Real>(curve.value) + ToLanes<Real>(curve.slope) * (x - ToLanes<Real>(curve.origin));
  for (const auto& hinge : curve.hinges) {
    sum = sum + ToLanes<Real>(hinge.slope_change) * Max(x - ToLanes<Real>(hinge.at), Real(0));
  }
  return sum;
}

/// The x at which a rising curve has the value y.
double InvertCurve(const CurveModel& curve, double y);

/// Its steepest slope: what decides the critical time step.
double SteepestSlope(const CurveModel& curve);

}  // namespace dbd
