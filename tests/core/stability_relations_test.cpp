#include <dbd/core/stability_relations.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"

namespace dbd {
namespace {

// A side-by-side of 1.45 m track whose centre of mass lies 0.475 m high.
constexpr SupportGeometry kSideBySide{1.45, 0.475};

TEST(StabilityRelations, StaticStabilityFactor) {
  ExpectPrinted(StaticStabilityFactor(kSideBySide), 1.52632);
  ExpectPrinted(ToDegrees(std::atan(StaticStabilityFactor(kSideBySide))), 56.7683);
}

TEST(StabilityRelations, QuasiStaticLoadTransfer) {
  ExpectPrinted(QuasiStaticLoadTransfer(kSideBySide, {3, 0, 0}), 0.200359);
  ExpectPrinted(QuasiStaticLoadTransfer(kSideBySide, {3, Degrees(10), 0}), 0.318974);
  ExpectPrinted(QuasiStaticLoadTransfer({1.6, 0.8}, {4, Degrees(15), 0}), 0.690080);
  // A side lifts at the tilt angle of the stability factor.
  EXPECT_NEAR(QuasiStaticLoadTransfer(kSideBySide, {0, std::atan(1.45 / 0.95), 0}), 1, 1e-12);
}

TEST(StabilityRelations, SpeedForLoadTransfer) {
  const double speed = SpeedForLoadTransfer(kSideBySide, 0.7, 10);
  ExpectPrinted(speed, 10.2378);
  EXPECT_NEAR(QuasiStaticLoadTransfer(kSideBySide, {speed * speed / 10, 0, 0}), 0.7, 1e-12);
}

TEST(StabilityRelations, EnergyMargin) {
  ExpectPrinted(EnergyMargin(kSideBySide, 0), 0.391747);
  ExpectPrinted(EnergyMargin(kSideBySide, Degrees(20)), 0.172428);
  EXPECT_NEAR(EnergyMargin(kSideBySide, Degrees(56.7683)), 0, 1e-6);
  EXPECT_LT(EnergyMargin(kSideBySide, Degrees(60)), 0);
}

TEST(StabilityRelations, ForceAngleMargin) {
  ExpectPrinted(ForceAngleMargin(kSideBySide, 3), 0.560120);
  EXPECT_NEAR(ForceAngleMargin(kSideBySide, 0), 1, 1e-12);
  EXPECT_NEAR(ForceAngleMargin(kSideBySide, 1.52632 * kGravity), 0, 1e-5);
  EXPECT_LT(ForceAngleMargin(kSideBySide, 20), 0);
}

TEST(StabilityRelations, BreakOverAndCrest) {
  ExpectPrinted(ToDegrees(BreakOverAngle(2.0, 0.33)), 36.5258);
  ExpectPrinted(LeastCrestRadius(2.0, 0.33), 1.68015);
  ExpectPrinted(ToDegrees(BreakOverAngle(2.72, 0.30)), 24.8791);
  ExpectPrinted(LeastCrestRadius(2.72, 0.30), 3.23267);
}

TEST(StabilityRelations, FrictionToClimbAStep) {
  ExpectPrinted(StepFriction(0.3175, 0.10), 1.06345);
  ExpectPrinted(StepFriction(0.3175, 0.20), 2.51028);
  ExpectPrinted(StepFriction(0.39243, 0.20), 1.77733);
  EXPECT_EQ(StepFriction(0.3, 0), 0);
}

}  // namespace
}  // namespace dbd
