#include <dbd/core/tire_stiffness.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"

namespace dbd {
namespace {

TEST(TireStiffness, LoadRatingWorkedExamples) {
  ExpectPrinted(LoadRatingStiffness(1456, 0.1651), 55118.1);
  ExpectPrinted(LoadRatingStiffness(2223, 0.1778), 78142.6);
  ExpectPrinted(LoadRatingStiffness(1800, 0.19685), 57150.1);
}

TEST(TireStiffness, ForestTireWorkedExamples) {
  ExpectPrinted(ForestTireDeflection(25e3, 110e3), 0.0485614);
  ExpectPrinted(ForestTireDeflection(2223, 172369), 0.00380384, 5);
}

TEST(TireStiffness, PressureLine) { EXPECT_EQ(PressureLineStiffness(200e3), 350e3); }

TEST(TireStiffness, GrowsAsTheTireBottoms) {
  EXPECT_DOUBLE_EQ(ProgressiveStiffness(70e3, 0.16, 0), 70e3);
  EXPECT_DOUBLE_EQ(ProgressiveStiffness(70e3, 0.16, 0.08), 140e3);
  EXPECT_DOUBLE_EQ(ProgressiveStiffness(70e3, 0.16, 0.3), 700e3);
}

TEST(TireStiffness, DampingRatiosOfAFiveHundredNewtonDamper) {
  // 500 N s/m against a wheel of 28.55 kg: 0.102832 of critical at 207.021 kN/m, 0.183519 at 65.
  EXPECT_NEAR(TireDamping(207021, 28.55, 0.102832), 500, 0.005);
  EXPECT_NEAR(TireDamping(65e3, 28.55, 0.183519), 500, 0.005);
}

}  // namespace
}  // namespace dbd
