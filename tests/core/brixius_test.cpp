#include "brixius.h"

#include <dbd/core/terramechanics.h>

#include <gtest/gtest.h>

#include "support/core_tire.h"

namespace dbd {
namespace {

constexpr BrixiusCoefficients kBias{};

TireModel RearTire() {
  TireModel tire;
  tire.radius = 0.3302;
  tire.width = 0.3048;
  tire.section_height = 0.1778;
  tire.stiffness = 75e3;
  return tire;
}

TEST(Brixius, EngineAndPublicFormulasAgree) {
  // 2223 N on 75 kN/m deflects 29.64 mm.
  const double engine = MobilityNumberOf(RearTire(), 300e3, 2223.0, 0.02964);
  const double plain = BrixiusMobilityNumber(300e3, 2223, 0.3048, 0.6604, 0.02964 / 0.1778);
  EXPECT_NEAR(engine, plain, 1e-12);
  EXPECT_NEAR(TractionCapacity(kBias, engine), GrossTractionRatio(kBias, engine, 1e9) - 0.04,
              1e-12);
  EXPECT_NEAR(SoilResistance(kBias, engine, -0.3), MotionResistanceRatio(kBias, engine, 0.3) - 0.04,
              1e-12);
  EXPECT_EQ(RollingRadius(0.33, 0.02), LoadedRollingRadius(0.33, 0.02));
}

TEST(Brixius, HardSoilIsCapped) {
  EXPECT_EQ(MobilityNumberOf(RearTire(), 1e8, 2000.0, 0.01), kHardSoilMobility);
}

TEST(Brixius, WithoutLoadNothingIsDividedByZero) {
  const double mobility = MobilityNumberOf(RearTire(), 300e3, 0.0, 0.0);
  EXPECT_EQ(mobility, kHardSoilMobility);
  EXPECT_TRUE(std::isfinite(SoilResistance(kBias, 0.0, 1.0)));
}

TEST(Brixius, SoftSoilCarriesNoTraction) {
  EXPECT_EQ(TractionCapacity(kBias, 0.0), 0);
  EXPECT_NEAR(TractionCapacity(kBias, 80.0), 0.88 * (1 - std::exp(-8.0)), 1e-15);
}

}  // namespace
}  // namespace dbd
