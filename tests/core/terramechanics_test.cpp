#include <dbd/core/terramechanics.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"
#include "support/core_test_tires.h"

namespace dbd {
namespace {

// Worked examples with six digits, after Brixius 1987 / ASABE D497 and Lines & Murphy 1991.
constexpr BrixiusCoefficients kBias{};
constexpr BrixiusCoefficients kRadial{0.88, 0.1, 9.5, 0.0325, 0.9, 0.5};
constexpr BrixiusCoefficients kRadialPan{0.88, 0.1, 10.5, 0.0325, 0.9, 0.5};

double Mobility(const TestTire& t, double cone_index) {
  return BrixiusMobilityNumber(cone_index, t.load, t.width, t.diameter, t.deflection_ratio);
}

struct WorkedExample {
  TestTire tire;
  BrixiusCoefficients coefficients;
  double cone_index, slip;
  double wheel_numeric, mobility, gross, resistance, net, efficiency;
};

class BrixiusExamples : public ::testing::TestWithParam<WorkedExample> {};

TEST_P(BrixiusExamples, AgreeToThePrintedDigits) {
  const WorkedExample& e = GetParam();
  const TestTire& t = e.tire;
  const double mobility = Mobility(t, e.cone_index);
  ExpectPrinted(WheelNumeric(e.cone_index, t.load, t.width, t.diameter), e.wheel_numeric);
  ExpectPrinted(mobility, e.mobility);
  ExpectPrinted(GrossTractionRatio(e.coefficients, mobility, e.slip), e.gross);
  ExpectPrinted(MotionResistanceRatio(e.coefficients, mobility, e.slip), e.resistance);
  ExpectPrinted(NetTractionRatio(e.coefficients, mobility, e.slip), e.net);
  ExpectPrinted(NetTractionRatio(e.coefficients, mobility, e.slip) /
                    GrossTractionRatio(e.coefficients, mobility, e.slip) * (1 - e.slip),
                e.efficiency);
}

INSTANTIATE_TEST_SUITE_P(
    Terramechanics, BrixiusExamples,
    ::testing::Values(WorkedExample{kT1, kBias, 900e3, 0.1, 29.5051, 32.8146, 0.486871, 0.0792027,
                                    0.407669, 0.753591},
                      WorkedExample{kT2, kRadial, 300e3, 0.15, 26.5863, 22.7662, 0.632259, 0.087751,
                                    0.544508, 0.732029},
                      WorkedExample{kT3, kRadial, 100e3, 0.2, 9.05488, 6.96226, 0.40784, 0.199667,
                                    0.208173, 0.408342},
                      WorkedExample{kT2, kRadialPan, 300e3, 0.15, 26.5863, 22.7662, 0.658714,
                                    0.087751, 0.570963, 0.736767}));

TEST(Terramechanics, NegativeSlipContinuesTheCurveAsAnOddFunction) {
  const double mobility = Mobility(kT2, 300e3);
  ExpectPrinted(GrossTractionRatio(kRadial, mobility, -0.2), -0.639073);
  ExpectPrinted(NetTractionRatio(kRadial, mobility, -0.2), -0.732064);
  for (double slip = 0.01; slip <= 1; slip += 0.09) {
    const double ct = kRadial.carcass_loss;
    EXPECT_NEAR(GrossTractionRatio(kRadial, mobility, slip) - ct,
                -(GrossTractionRatio(kRadial, mobility, -slip) - ct), 1e-15);
    EXPECT_EQ(MotionResistanceRatio(kRadial, mobility, slip),
              MotionResistanceRatio(kRadial, mobility, -slip));
  }
}

struct Anchor {
  BrixiusCoefficients coefficients;
  double mobility, max_net, slip;
};

class NetTractionAnchors : public ::testing::TestWithParam<Anchor> {};

TEST_P(NetTractionAnchors, LargestNetTractionAndItsSlip) {
  const NetTractionOptimum best = MaxNetTraction(GetParam().coefficients, GetParam().mobility);
  ExpectPrinted(best.ratio, GetParam().max_net);
  ExpectPrinted(best.slip, GetParam().slip);
}

INSTANTIATE_TEST_SUITE_P(Terramechanics, NetTractionAnchors,
                         ::testing::Values(Anchor{kBias, 10, 0.366187, 0.436378},
                                           Anchor{kBias, 20, 0.637373, 0.524356},
                                           Anchor{kBias, 40, 0.781896, 0.587489},
                                           Anchor{kBias, 55, 0.808063, 0.610638},
                                           Anchor{kBias, 80, 0.824191, 0.636119},
                                           Anchor{kRadial, 10, 0.391217, 0.369392},
                                           Anchor{kRadial, 20, 0.655071, 0.438848},
                                           Anchor{kRadial, 40, 0.794426, 0.488691},
                                           Anchor{kRadial, 55, 0.818764, 0.506966},
                                           Anchor{kRadial, 80, 0.833106, 0.527082}));

TEST(Terramechanics, NetTractionVanishesAtTheCriticalMobility) {
  EXPECT_NEAR(MaxNetTraction(kBias, 4.5708).ratio, 0, 1e-5);
  EXPECT_NEAR(MaxNetTraction(kRadial, 4.21301).ratio, 0, 1e-5);
}

TEST(Terramechanics, TowedWheelTurnsAtTheSlipWithoutGrossTraction) {
  const std::pair<double, double> towed[] = {
      {10, -0.00994993}, {20, -0.00720015}, {40, -0.00632118}, {55, -0.00622873}, {80, -0.0062048}};
  for (const auto& [mobility, slip] : towed) {
    EXPECT_NEAR(GrossTractionRatio(kBias, mobility, slip), 0, 1e-7) << mobility;
  }
}

TEST(Terramechanics, PeakEfficiency) {
  struct Peak {
    BrixiusCoefficients c;
    double mobility, efficiency, slip;
  };
  const Peak peaks[] = {{kBias, 80, 0.800036, 0.0803},   {kBias, 40, 0.768578, 0.0903},
                        {kBias, 20, 0.695293, 0.1127},   {kRadial, 80, 0.833817, 0.0660},
                        {kRadial, 40, 0.805778, 0.0746}, {kRadial, 20, 0.740530, 0.0935}};
  for (const Peak& p : peaks) {
    const double gross = GrossTractionRatio(p.c, p.mobility, p.slip);
    ExpectPrinted(NetTractionRatio(p.c, p.mobility, p.slip) / gross * (1 - p.slip), p.efficiency);
  }
}

TEST(Terramechanics, SlipHasOneDefinitionForDrivingBrakingAndReversing) {
  ExpectPrinted(Slip(2.2, 2.0), 0.0909091);
  EXPECT_DOUBLE_EQ(Slip(1.6, 2.0), -0.2);
  EXPECT_DOUBLE_EQ(Slip(0.05, 0.02), 0.3);    // below the floor of 0.1 m/s
  ExpectPrinted(Slip(-1.0, -1.2), 0.166667);  // braking while reversing pushes forward
  EXPECT_EQ(Slip(0, 0), 0);
  EXPECT_EQ(Slip(3, 0), 1);
  EXPECT_EQ(Slip(0, 3), -1);
}

TEST(Terramechanics, RollingRadius) {
  ExpectPrinted(LoadedRollingRadius(0.8775, 0.072), 0.832834);
  ExpectPrinted(LoadedRollingRadius(0.3175, 0.0224), 0.30367);
  ExpectPrinted(LoadedRollingRadius(0.3302, 0.02964), 0.311754);
  EXPECT_DOUBLE_EQ(LoadedRollingRadius(0.4, 0), 0.4);
}

TEST(Terramechanics, LinesMurphyStiffness) {
  const double in = 0.0254, psi = 6894.757;
  ExpectPrinted(LinesMurphyStiffness(38 * in, 18.4 * in, 1.10e5), 366.241e3);
  ExpectPrinted(LinesMurphyStiffness(34 * in, 16.9 * in, 1.0e5, 5), 335.184e3);
  ExpectPrinted(LinesMurphyStiffness(12 * in, 8 * in, 25 * psi), 207.021e3);
  ExpectPrinted(LinesMurphyStiffness(12 * in, 12 * in, 25 * psi), 235.152e3);
}

TEST(Terramechanics, MoreStrengthMeansMoreTraction) {
  double net = -1e9;
  for (double cone_index = 50e3; cone_index < 2e6; cone_index *= 1.2) {
    const double next_net = MaxNetTraction(kBias, Mobility(kT3, cone_index)).ratio;
    EXPECT_GT(next_net, net);
    net = next_net;
  }
}

TEST(Terramechanics, GrossTractionGrowsWithSlipAndIsContinuousAtZero) {
  const double mobility = 30;
  for (double slip = -1; slip < 1; slip += 0.01) {
    EXPECT_GT(GrossTractionRatio(kBias, mobility, slip + 0.01),
              GrossTractionRatio(kBias, mobility, slip));
  }
  EXPECT_NEAR(GrossTractionRatio(kBias, mobility, 1e-9), GrossTractionRatio(kBias, mobility, -1e-9),
              1e-7);
  EXPECT_DOUBLE_EQ(GrossTractionRatio(kBias, mobility, 0), kBias.carcass_loss);
}

TEST(Terramechanics, RatiosDoNotDependOnTheUnits) {
  // Forces in units of a newtons and lengths in units of b metres: cone index scales with a / b^2.
  const double a = 1 / 4.4482216, b = 1 / 0.0254;
  const TestTire& t = kT3;
  const TestTire scaled{b * t.width, b * t.diameter, a * t.load, t.deflection_ratio};
  const double ci = 100e3, scaled_ci = ci * a / (b * b);
  EXPECT_NEAR(Mobility(scaled, scaled_ci), Mobility(t, ci), 1e-12);
  EXPECT_NEAR(LoadedRollingRadius(b * 0.33, b * 0.02), b * LoadedRollingRadius(0.33, 0.02), 1e-13);
}

}  // namespace
}  // namespace dbd
