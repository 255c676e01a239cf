#include "curve.h"

#include <dbd/core/error.h>

#include <algorithm>

namespace dbd {

CurveModel MakeCurve(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2 || x.size() != y.size()) throw InputError("needs two points or more");
  CurveModel curve;
  double slope = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    if (!(x[i + 1] > x[i] && y[i + 1] > y[i])) {
      throw InputError("must rise from point to point in both columns");
    }
    const double next = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    if (i > 0) curve.hinges.push_back({x[i], next - slope});
    if (i == 0) curve.slope = next;
    slope = next;
  }
  curve.origin = x[0];
  curve.value = y[0];
  return curve;
}

double InvertCurve(const CurveModel& curve, double y) {
  double x = curve.origin, value = curve.value, slope = curve.slope;
  for (const CurveModel::Hinge& hinge : curve.hinges) {
    const double next = value + slope * (hinge.at - x);
    if (y < next) break;
    value = next;
    x = hinge.at;
    slope += hinge.slope_change;
  }
  return x + (y - value) / slope;
}

double SteepestSlope(const CurveModel& curve) {
  double slope = curve.slope, steepest = curve.slope;
  for (const CurveModel::Hinge& hinge : curve.hinges) {
    slope += hinge.slope_change;
    steepest = std::max(steepest, slope);
  }
  return steepest;
}

}  // namespace dbd
