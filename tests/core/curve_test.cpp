#include "curve.h"

#include <dbd/core/error.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

CurveModel Progressive() { return MakeCurve({-0.1, 0, 0.05, 0.1}, {-500, 0, 1000, 4000}); }

TEST(Curve, GoesThroughItsPointsAndOnAlongTheOuterSegments) {
  const CurveModel curve = Progressive();
  EXPECT_NEAR(EvaluateCurve(curve, -0.1), -500, 1e-9);
  EXPECT_NEAR(EvaluateCurve(curve, 0.0), 0, 1e-9);
  EXPECT_NEAR(EvaluateCurve(curve, 0.025), 500, 1e-9);
  EXPECT_NEAR(EvaluateCurve(curve, 0.1), 4000, 1e-9);
  EXPECT_NEAR(EvaluateCurve(curve, 0.12), 5200, 1e-9);   // 4000 + 0.02 * 60000
  EXPECT_NEAR(EvaluateCurve(curve, -0.2), -1000, 1e-9);  // -500 - 0.1 * 5000
  EXPECT_NEAR(SteepestSlope(curve), 60000, 1e-6);
}

TEST(Curve, InverseOfEveryPart) {
  const CurveModel curve = Progressive();
  for (const double x : {-0.3, -0.1, -0.01, 0.0, 0.02, 0.05, 0.08, 0.1, 0.4}) {
    EXPECT_NEAR(InvertCurve(curve, EvaluateCurve(curve, x)), x, 1e-12) << x;
  }
}

TEST(Curve, RefusesWhatDoesNotRise) {
  EXPECT_THROW(MakeCurve({0}, {0}), InputError);
  EXPECT_THROW(MakeCurve({0, 1}, {0}), InputError);
  EXPECT_THROW(MakeCurve({0, 0}, {0, 1}), InputError);
  EXPECT_THROW(MakeCurve({0, 1}, {1, 1}), InputError);
}

}  // namespace
}  // namespace dbd
