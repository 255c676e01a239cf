#include <dbd/core/terramechanics.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"
#include "support/core_test_tires.h"

namespace dbd {
namespace {

double Numeric(const TestTire& t) {
  return WheelNumeric(t.cone_index, t.load, t.width, t.diameter);
}
double Turnage(const TestTire& t) {
  return TurnageMobilityNumber(t.cone_index, t.load, t.width, t.diameter, t.deflection_ratio);
}
ClayNumerics Clay(const TestTire& t) {
  return FineGrainedNumerics(t.cone_index, t.load, t.width, t.diameter, t.deflection_ratio);
}

TEST(WismerLuth, WorkedExamples) {
  const struct {
    TestTire tire;
    double gross, resistance, net;
  } rows[] = {{kT1, 0.440511, 0.080671, 0.35984},
              {kT2, 0.523286, 0.0851361, 0.438149},
              {kT3, 0.314376, 0.172525, 0.14185}};
  for (const auto& row : rows) {
    const TractionRatios ratios = WismerLuthTraction(Numeric(row.tire), row.tire.slip);
    ExpectPrinted(ratios.gross, row.gross);
    ExpectPrinted(ratios.resistance, row.resistance);
    ExpectPrinted(ratios.net, row.net);
  }
}

TEST(WismerLuth, IsOddInSlip) {
  EXPECT_EQ(WismerLuthTraction(30, 0).gross, 0);
  for (const double slip : {1e-9, 0.1, 0.7}) {
    EXPECT_EQ(WismerLuthTraction(30, slip).gross, -WismerLuthTraction(30, -slip).gross);
  }
}

TEST(GeeClough, WorkedExamples) {
  const struct {
    TestTire tire;
    double mobility, max_net, rate, net, towed;
  } rows[] = {{kT1, 11.6456, 0.717, 7.73833, 0.38629, 0.0736444},
              {kT2, 8.44209, 0.687022, 7.79155, 0.473523, 0.0829963},
              {kT3, 3.00386, 0.489727, 10.2531, 0.426722, 0.144544}};
  for (const auto& row : rows) {
    ExpectPrinted(Turnage(row.tire), row.mobility);
    const GeeCloughTraction traction = GeeCloughNetTraction(Turnage(row.tire), row.tire.slip);
    ExpectPrinted(traction.max_net, row.max_net);
    ExpectPrinted(traction.rate, row.rate);
    ExpectPrinted(traction.net, row.net);
    ExpectPrinted(traction.towed_resistance, row.towed);
  }
}

TEST(GeeClough, NoPullBelowTheCriticalMobility) {
  EXPECT_NEAR(GeeCloughNetTraction(1.1558, 0.2).max_net, 0, 2e-5);
  EXPECT_LT(GeeCloughNetTraction(1.1, 0.2).max_net, 0);
}

TEST(FineGrained, WorkedExamples) {
  const struct {
    TestTire tire;
    double uncorrected, numeric, self_propelled, net, resistance, gross;
  } rows[] = {{kT1, 41.2346, 34.5471, 0.00799358, 0.581963, 0.0170545, 0.599018},
              {kT2, 33.0858, 26.8665, 0.0106129, 0.616464, 0.0236249, 0.640089},
              {kT3, 11.9037, 8.95522, 0.0925043, 0.184097, 0.156634, 0.340731}};
  for (const auto& row : rows) {
    const ClayNumerics clay = Clay(row.tire);
    ExpectPrinted(clay.uncorrected, row.uncorrected);
    ExpectPrinted(clay.numeric, row.numeric);
    ExpectPrinted(clay.self_propelled_slip, row.self_propelled);
    const TractionRatios ratios =
        FineGrainedTraction(clay, row.tire.width, row.tire.diameter, row.tire.slip);
    ExpectPrinted(ratios.net, row.net);
    ExpectPrinted(ratios.resistance, row.resistance);
    ExpectPrinted(ratios.gross, row.gross);
  }
}

TEST(FineGrained, NetPullVanishesAtTheSelfPropelledSlip) {
  const ClayNumerics clay = Clay(kT2);
  EXPECT_NEAR(FineGrainedTraction(clay, 0.2, 0.6, clay.self_propelled_slip).net, 0, 1e-15);
  // 5.07 / 26.8665^1.71 + 0.011 = 5.07 / 277.96 + 0.011.
  EXPECT_NEAR(FineGrainedTowedResistance(clay), 0.02924, 2e-5);
}

TEST(Sand, WorkedExample) {
  const double gradient = SandGradient(800e3);
  ExpectPrinted(gradient / 1e3, 9076.68);
  const double numeric =
      SandNumeric(gradient, kT3.load, kT3.width, kT3.diameter, kT3.deflection_ratio);
  ExpectPrinted(numeric, 61.4705);
  ExpectPrinted(SandGrossTraction(numeric, 0.2), 0.556384);
  EXPECT_EQ(SandGrossTraction(numeric, 0), 0);
  EXPECT_NEAR(SandGrossTraction(numeric, 1e-9), 0, 1e-7);
}

TEST(LateralForce, WorkedExamples) {
  const struct {
    double mobility, degrees, bias, radial;
  } rows[] = {{Turnage(kT3), 5, 0.199112, 0.240053},
              {Turnage(kT2), 5, 0.222888, 0.290756},
              {Turnage(kT2), 10, 0.373958, 0.475838},
              {20, 10, 0.432162, 0.583455}};
  for (const auto& row : rows) {
    const double angle = Degrees(row.degrees);
    ExpectPrinted(LateralForceRatio(BiasLateralCoefficients(row.mobility), angle), row.bias);
    ExpectPrinted(LateralForceRatio(RadialLateralCoefficients(row.mobility), angle), row.radial);
  }
  EXPECT_LE(BiasLateralCoefficients(1).limit, 1);
}

TEST(LateralForce, RelaxationAngleLaw) {
  const LateralCoefficients law{1, 1 / 0.09};
  ExpectPrinted(LateralForceRatio(law, Degrees(2)), 0.321487);
  ExpectPrinted(LateralForceRatio(law, Degrees(5)), 0.620776);
  ExpectPrinted(LateralForceRatio(law, -Degrees(10)), 0.856189);
}

TEST(Ellipse, WorkedExamples) {
  // T2 at slip 0.15: shear part 0.632259 - 0.0325 of 0.88 (1 - e^-2.27662) = 0.789685.
  const BrixiusCoefficients radial{0.88, 0.1, 9.5, 0.0325, 0.9, 0.5};
  const double mobility = BrixiusMobilityNumber(kT2.cone_index, kT2.load, kT2.width, kT2.diameter,
                                                kT2.deflection_ratio);
  const double shear = GrossTractionRatio(radial, mobility, 0.15) - radial.carcass_loss;
  ExpectPrinted(shear, 0.599759);
  const double limit = shear / (1 - std::exp(-9.5 * 0.15));
  ExpectPrinted(limit, 0.789685);
  const double free = LateralForceRatio(RadialLateralCoefficients(Turnage(kT2)), Degrees(5));
  ExpectPrinted(EllipseLateralForce(free, shear, limit), 0.189142);
  ExpectPrinted(EllipseLateralForce(0.4, 0.5, 0.8), 0.312250);
  EXPECT_EQ(EllipseLateralForce(0.4, 0.9, 0.8), 0);
}

TEST(NicolasComstock, WorkedExample) {
  const PureSlipForces pure{873.249, 423.341, 10922.9, 6028.91};
  const CombinedForces forces = NicolasComstockForces(pure, 0.15, Degrees(5));
  ExpectPrinted(forces.longitudinal, 721.022);
  ExpectPrinted(forces.lateral, 347.881);
  ExpectPrinted(EllipseLateralForce(pure.lateral, pure.longitudinal, 1456 * 0.789685), 275.391, 5);
}

TEST(AligningTorque, WorkedExamples) {
  const double length = ContactLength(0.3175, 0.0224);
  ExpectPrinted(length, 0.168665);
  ExpectPrinted(PneumaticTrail(length, 0), 0.0300224);
  ExpectPrinted(PneumaticTrail(length, 0.1), 0.0217971);
  EXPECT_EQ(PneumaticTrail(length, 0.5), 0);
}

}  // namespace
}  // namespace dbd
