#include <dbd/core/sinkage.h>
#include <dbd/core/soil_strength.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/traction_relations.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"
#include "support/core_test_tires.h"

namespace dbd {
namespace {

WheelFooting Footing(const TestTire& t) {
  return {t.cone_index, t.load, t.width, t.diameter, t.deflection_ratio};
}
double Powered(const WheelFooting& w) {
  return PoweredSinkage(w.cone_index, w.load, w.width, w.diameter, w.deflection_ratio);
}
double Turnage(const TestTire& t) {
  return TurnageMobilityNumber(t.cone_index, t.load, t.width, t.diameter, t.deflection_ratio);
}

TEST(Sinkage, FineGrainedWorkedExamples) {
  const WheelFooting wheel = Footing(kT3);
  ExpectPrinted(PoweredSinkageAtSlip(wheel, 0.2) / kT3.diameter, 0.0471166);
  ExpectPrinted(PoweredSinkageAtSlip(wheel, 0.2), 0.0311158);
  ExpectPrinted(Powered(wheel) / kT3.diameter, 0.0473791);
  ExpectPrinted(Powered(wheel), 0.0312892);
  ExpectPrinted(UnpoweredSinkage(wheel) / kT3.diameter, 0.0394889);
  ExpectPrinted(UnpoweredSinkage(wheel), 0.0260785);
}

TEST(Sinkage, PoweredFormsAgreeWithinTheStatedShares) {
  const std::pair<TestTire, double> shares[] = {{kT3, 0.006}, {kT2, 0.07}, {kT1, 0.21}};
  for (const auto& [tire, share] : shares) {
    const double ratio = PoweredSinkageAtSlip(Footing(tire), tire.slip) / Powered(Footing(tire));
    EXPECT_NEAR(std::abs(ratio - 1), share, 0.005);
  }
}

TEST(Sinkage, MaclaurinWorkedExamples) {
  ExpectPrinted(MaclaurinSinkage(Turnage(kT3), kT3.diameter), 0.0374073);
  ExpectPrinted(MaclaurinSinkage(Turnage(kT2), kT2.diameter), 0.00988461);
  ExpectPrinted(MaclaurinSinkage(Turnage(kT1), kT1.diameter), 0.0182735);
}

TEST(Sinkage, MultipassRutWorkedExamples) {
  const double first = MaclaurinSinkage(Turnage(kT3), kT3.diameter);
  ExpectPrinted(MultipassSinkage(first, 4, 3), 0.0593804);
  ExpectPrinted(MultipassSinkage(first, 4, 2), 0.0748146);
  EXPECT_EQ(MultipassSinkage(first, 1, 3), first);
}

TEST(Sinkage, SandWorkedExample) {
  WheelFooting wheel = Footing(kT3);
  wheel.cone_index = 800e3;
  ExpectPrinted(SandSinkage(wheel) / kT3.diameter, 0.00911753, 5);
  ExpectPrinted(SandSinkage(wheel), 0.00602122, 5);
}

TEST(Sinkage, MultipassStrengthWorkedExamples) {
  ExpectPrinted(MultipassConeIndexRatio(20), 1.19945);
  ExpectPrinted(MultipassConeIndexRatio(6.96226), 1.83689);
  ExpectPrinted(MultipassConeIndexRatio(40), 1.0221, 5);
  EXPECT_EQ(MultipassConeIndexRatio(1), 2);
}

TEST(Sinkage, OperatingSinkageGrowsWithSlipFromTheSelfPropelledValue) {
  const WheelFooting wheel = Footing(kT3);
  EXPECT_EQ(OperatingSinkage(wheel, 0), Powered(wheel));
  EXPECT_EQ(OperatingSinkage(wheel, 0.8), PoweredSinkageAtSlip(wheel, 0.8));
  EXPECT_EQ(OperatingSinkage(wheel, -0.8), OperatingSinkage(wheel, 0.8));
  double last = 0;
  for (double slip = 0; slip <= 1; slip += 0.05) {
    EXPECT_GE(OperatingSinkage(wheel, slip), last);
    last = OperatingSinkage(wheel, slip);
  }
}

TEST(Sinkage, MultipassIsOffUnlessAskedFor) {
  const WheelFooting wheel = Footing(kT3);
  EXPECT_EQ(OperatingSinkage(wheel, 0.1, 4), OperatingSinkage(wheel, 0.1, 1));
  ExpectPrinted(OperatingSinkage(wheel, 0.1, 4, {.multipass_exponent = 3}), 0.0593804);
  ExpectPrinted(OperatingSinkage(wheel, 0.1, 1, {.multipass_exponent = 3}), 0.0374073);
}

TEST(Sinkage, NothingWithoutLoad) {
  WheelFooting wheel = Footing(kT3);
  double last = 1;
  for (const double load : {1000.0, 10.0, 0.1, 1e-6}) {
    wheel.load = load;
    EXPECT_LT(OperatingSinkage(wheel, 1), last);
    last = OperatingSinkage(wheel, 1);
  }
  EXPECT_LT(last, 1e-9);
  wheel.load = 0;
  EXPECT_EQ(OperatingSinkage(wheel, 1), 0);
}

TEST(Sinkage, StrongerSoilMeansLess) {
  WheelFooting wheel = Footing(kT3);
  double last = 1e9;
  for (wheel.cone_index = 50e3; wheel.cone_index < 2e6; wheel.cone_index *= 1.2) {
    EXPECT_LT(OperatingSinkage(wheel, 0.1), last);
    last = OperatingSinkage(wheel, 0.1);
  }
}

TEST(Sinkage, ScalesWithTheUnits) {
  const double a = 1 / 4.4482216, b = 1 / 0.0254;
  const WheelFooting si = Footing(kT3);
  const WheelFooting imperial{si.cone_index * a / (b * b), a * si.load, b * si.width,
                              b * si.diameter, si.deflection_ratio};
  EXPECT_NEAR(OperatingSinkage(imperial, 0.3), b * OperatingSinkage(si, 0.3), 1e-11);
}

}  // namespace
}  // namespace dbd
