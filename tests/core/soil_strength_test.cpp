#include <dbd/core/soil_strength.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_printed.h"
#include "support/core_test_tires.h"

namespace dbd {
namespace {

constexpr double kPound = 4.4482216, kHorsepower = 745.69987;

double ToPsi(double pascals) { return pascals / Psi(1); }

MobilityIndexVehicle Truck8x8() {
  return {36320 * kPound, 4, 8, Inches(14.5), Inches(45), Inches(21), 350 * kHorsepower};
}
MobilityIndexVehicle Utility4x4() {
  return {7700 * kPound, 2, 4, Inches(12.5), Inches(37), Inches(16), 150 * kHorsepower};
}

TEST(SoilStrength, RatingConeIndexOfTwoSurveys) {
  EXPECT_NEAR(RatingConeIndex(49, 0.87), 42.63, 1e-12);
  EXPECT_NEAR(RatingConeIndex(56, 0.85), 47.6, 1e-12);
}

TEST(MobilityIndex, EightWheelTruck) {
  const MobilityIndexFactors f = FactorsOf(Truck8x8());
  ExpectPrinted(f.contact_pressure, 13.9157);
  ExpectPrinted(f.weight, 1.34964);
  EXPECT_NEAR(f.tire, 0.245, 1e-12);
  EXPECT_NEAR(f.wheel_load, 4.54, 1e-12);
  EXPECT_NEAR(f.clearance, 2.1, 1e-12);
  const double index = MobilityIndex(f);
  ExpectPrinted(index, 79.0979);
  ExpectPrinted(ToPsi(VehicleConeIndexOnePass(index)), 26.8264);
  ExpectPrinted(VehicleConeIndexOnePass(index) / 1e3, 184.961);
  ExpectPrinted(ToPsi(VehicleConeIndexOnePass(index, 0.25)), 23.6102);
  ExpectPrinted(ToPsi(VehicleConeIndexFiftyPasses(index)), 61.1225);
}

TEST(MobilityIndex, UtilityVehicle) {
  const MobilityIndexFactors f = FactorsOf(Utility4x4());
  ExpectPrinted(f.contact_pressure, 8.32432);
  ExpectPrinted(f.weight, 1.17705);
  EXPECT_NEAR(f.tire, 0.225, 1e-12);
  EXPECT_NEAR(f.wheel_load, 1.925, 1e-12);
  EXPECT_NEAR(f.clearance, 1.6, 1e-12);
  const double index = MobilityIndex(f);
  ExpectPrinted(index, 43.8723);
  ExpectPrinted(ToPsi(VehicleConeIndexOnePass(index)), 19.4311);
  ExpectPrinted(VehicleConeIndexOnePass(index) / 1e3, 133.973);
  ExpectPrinted(ToPsi(VehicleConeIndexOnePass(index, 0.25)), 17.1016);
  ExpectPrinted(ToPsi(VehicleConeIndexFiftyPasses(index)), 45.1459);
}

TEST(MobilityIndex, SideBySideWithTheMeanOfItsTires) {
  MobilityIndexFactors f;
  f.contact_pressure = 0.5 * (3.2735 + 3.20353);
  f.weight = MobilityWeightFactor(1653 * kPound / 2);
  ExpectPrinted(f.weight, 0.457055);
  f.tire = 0.2;
  f.wheel_load = 1.653 / 4;
  f.clearance = 1.3;
  const double index = MobilityIndex(f);
  EXPECT_NEAR(index, 6.51413, 1e-5);
  ExpectPrinted(ToPsi(VehicleConeIndexOnePass(index)), 8.95998);
  ExpectPrinted(VehicleConeIndexOnePass(index) / 1e3, 61.7769);
}

TEST(MobilityIndex, LessPowerAManualGearboxAndNarrowTiresAskForMore) {
  const double index = MobilityIndex(FactorsOf(Truck8x8()));
  MobilityIndexVehicle worse = Truck8x8();
  worse.power = 100 * kHorsepower;  // 5.5 hp/ton
  EXPECT_NEAR(MobilityIndex(FactorsOf(worse)), 1.05 * index, 1e-12);
  worse.automatic_transmission = false;
  EXPECT_NEAR(MobilityIndex(FactorsOf(worse)), 1.05 * 1.05 * index, 1e-12);
  worse = Truck8x8();
  worse.tire_width *= 0.8;
  EXPECT_GT(MobilityIndex(FactorsOf(worse)), index);
  worse = Truck8x8();
  worse.chains = true;
  EXPECT_LT(MobilityIndex(FactorsOf(worse)), index);
}

TEST(MobilityIndex, WeightFactorIsNearlyContinuous) {
  // At 2 kips 1.106 and 1.116; at 13.5 kips 1.4955 and 1.497; at 20 kips 2.42 and 2.445.
  for (const double kips : {2.0, 13.5, 20.0}) {
    const double below = MobilityWeightFactor((kips - 1e-6) * 1000 * kPound);
    EXPECT_NEAR(MobilityWeightFactor((kips + 1e-6) * 1000 * kPound), below, 0.03);
  }
}

TEST(VehicleConeIndex, BranchesMeet) {
  // 34.4798 and 34.0318 psi at MI 115.
  EXPECT_NEAR(VehicleConeIndexOnePass(115.001) / VehicleConeIndexOnePass(115), 1, 0.02);
}

TEST(VehicleConeIndex, Tracked) {
  // MI 60: 7 + 12 - 39.2/65.6 = 18.4024; 19.27 + 25.8 - 125.79/67.08 = 43.1948.
  EXPECT_NEAR(ToPsi(TrackedConeIndexOnePass(60)), 18.4024, 1e-4);
  EXPECT_NEAR(ToPsi(TrackedConeIndexFiftyPasses(60)), 43.1948, 1e-4);
}

TEST(Maclaurin, WorkedExamples) {
  const auto numeric = [](const TestTire& t, double deflection) {
    return MaclaurinNumeric(t.cone_index, t.load, t.width, t.diameter, deflection);
  };
  ExpectPrinted(kT3.cone_index / numeric(kT3, kT3Deflection) / 1e3, 32.7439);
  ExpectPrinted(numeric(kT3, kT3Deflection), 3.054, 4);
  const auto limit = [](const TestTire& t, double deflection) {
    return LimitingConeIndex(t.load, t.width, t.diameter, deflection) / 1e3;
  };
  ExpectPrinted(limit(kT3, kT3Deflection), 60.5762);
  ExpectPrinted(limit(kT2, kT2Deflection), 63.3397);
  ExpectPrinted(limit({Inches(12.5), Inches(37), 8562.83, 0.15, 0, 0}, 0.15 * 0.26035), 152.513);
  ExpectPrinted(limit({Inches(14.5), Inches(45), 20194.9, 0.15, 0, 0}, 0.15 * 0.3175), 252.279);
}

/// Least cone index on which the largest net traction of a Brixius wheel is positive [kPa].
double BrixiusLimit(const TestTire& t, const BrixiusCoefficients& c) {
  double low = 1e3, high = 1e6;
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    const double mobility =
        BrixiusMobilityNumber(middle, t.load, t.width, t.diameter, t.deflection_ratio);
    (MaxNetTraction(c, mobility).ratio > 0 ? high : low) = middle;
  }
  return high / 1e3;
}

TEST(GoNoGo, ThreeCriteriaAgreeAsStated) {
  const BrixiusCoefficients radial{0.88, 0.1, 9.5, 0.0325, 0.9, 0.5};
  const TestTire utility{Inches(12.5), Inches(37), 8562.83, 0.15, 0, 0};
  const TestTire truck{Inches(14.5), Inches(45), 20194.9, 0.15, 0, 0};
  const struct {
    TestTire tire;
    double radial, bias;
  } rows[] = {{kT3, 60.5121, 65.6512},
              {kT2, 55.5166, 60.2314},
              {utility, 139.106, 150.920},
              {truck, 227.133, 246.422}};
  for (const auto& row : rows) {
    ExpectPrinted(BrixiusLimit(row.tire, radial), row.radial, 5);
    ExpectPrinted(BrixiusLimit(row.tire, {}), row.bias, 5);
  }
}

TEST(Nrmm, WorkedExamples) {
  const auto pull = [](double x) { return NrmmPullRatio(kNrmmHighPressure, Psi(x)); };
  ExpectPrinted(pull(5), 0.216959);
  ExpectPrinted(pull(20), 0.561229);
  ExpectPrinted(pull(60), 0.649417);
  EXPECT_EQ(pull(0), 0);
  EXPECT_NEAR(NrmmPullRatio(kNrmmLowPressure, Psi(20)), 0.6, 5e-5);
  ExpectPrinted(NrmmResistanceRatio(kNrmmHighPressure, 0), 0.4);
  ExpectPrinted(NrmmResistanceRatio(kNrmmHighPressure, Psi(20)), 0.132075);
  ExpectPrinted(NrmmResistanceRatio(kNrmmLowPressure, 0), 0.300005);
  ExpectPrinted(NrmmResistanceRatio(kNrmmLowPressure, Psi(20)), 0.0720339);
}

TEST(Uscs, PrintedTable) {
  const double moistures[] = {15, 20, 25, 30, 40};
  const struct {
    const char* name;
    double ci[5], rci[5];
  } rows[] = {{"SW", {489.8, 619.3, 742.8, 861.8, 1089.5}, {489.8, 619.3, 742.8, 861.8, 1089.5}},
              {"SP", {489.8, 619.3, 742.8, 861.8, 1089.5}, {489.8, 619.3, 742.8, 861.8, 1089.5}},
              {"SM", {247.9, 175.8, 134.7, 108.3, 76.8}, {93.7, 40.0, 20.7, 12.1, 5.2}},
              {"SC", {217.5, 147.2, 108.8, 84.9, 57.5}, {93.7, 40.0, 20.7, 12.1, 5.2}},
              {"SM-SC", {217.5, 147.2, 108.8, 84.9, 57.5}, {93.7, 40.0, 20.7, 12.1, 5.2}},
              {"ML", {398.2, 253.8, 179.0, 134.6, 85.8}, {225.4, 112.8, 65.9, 42.5, 21.3}},
              {"CL-ML", {299.9, 201.3, 147.8, 114.8, 77.1}, {311.3, 126.3, 62.7, 35.4, 14.4}},
              {"CL", {400.8, 235.5, 155.9, 111.3, 65.4}, {382.4, 138.5, 63.0, 33.1, 12.0}},
              {"OL", {506.3, 305.7, 206.7, 150.1, 90.6}, {2193.7, 782.3, 351.6, 182.9, 65.2}},
              {"CH", {917.0, 436.2, 245.1, 153.0, 72.8}, {578.7, 265.7, 145.3, 88.7, 40.8}},
              {"MH", {885.1, 491.6, 311.6, 214.6, 119.2}, {14523.3, 3262.2, 1024.4, 397.6, 89.3}},
              {"OH", {1292.2, 691.8, 426.1, 286.7, 153.5}, {1022.5, 584.8, 379.2, 266.1, 152.2}}};
  for (const auto& row : rows) {
    for (int i = 0; i < 5; ++i) {
      const SoilStrength strength = FittedSoilStrength(*UscsClassOf(row.name), moistures[i]);
      EXPECT_NEAR(ToPsi(strength.cone_index), row.ci[i], 0.0501) << row.name;
      EXPECT_NEAR(ToPsi(strength.rating_cone_index), row.rci[i], 0.0501) << row.name;
    }
  }
  EXPECT_FALSE(UscsClassOf("GW"));
}

TEST(Uscs, WorkedExamples) {
  const SoilStrength clay = FittedSoilStrength(UscsClass::kCL, 25);
  ExpectPrinted(ToPsi(clay.rating_cone_index), 63.0147);
  ExpectPrinted(clay.rating_cone_index / 1e3, 434.471);
  ExpectPrinted(ToPsi(FittedSoilStrength(UscsClass::kSM, 18).rating_cone_index), 54.6501);
}

TEST(Uscs, UsableStrengthIsKeptInRange) {
  const SoilStrength dry = SoilStrengthAt(UscsClass::kMH, 15);
  EXPECT_DOUBLE_EQ(ToPsi(dry.cone_index), 300);
  EXPECT_DOUBLE_EQ(ToPsi(dry.rating_cone_index), 300);
  const SoilStrength organic = SoilStrengthAt(UscsClass::kOL, 30);  // the fits cross when dry
  EXPECT_EQ(organic.rating_cone_index, organic.cone_index);
  EXPECT_NEAR(ToPsi(organic.cone_index), 150.1, 0.05);
  EXPECT_GE(ToPsi(SoilStrengthAt(UscsClass::kSM, 95).rating_cone_index), 1 - 1e-12);
}

TEST(Uscs, MoistureFactors) {
  // CL: exp(10.998 - 1.848 ln w) psi: 197.5 at 22 %, 83.75 at 35 %; at 12 % above 300.
  EXPECT_NEAR(MoistureFactor(UscsClass::kCL, MoistureState::kWet), 83.75 / 197.5, 1e-4);
  EXPECT_NEAR(MoistureFactor(UscsClass::kCL, MoistureState::kDry), 300 / 197.5, 1e-4);
  EXPECT_EQ(MoistureFactor(UscsClass::kCL, MoistureState::kMoist), 1);
  // CH holds 10 % more: (45/32)^-2.583.
  EXPECT_NEAR(MoistureFactor(UscsClass::kCH, MoistureState::kWet), 0.41446, 1e-4);
  // Clean sand is above 300 psi at all of them.
  EXPECT_EQ(MoistureFactor(UscsClass::kSP, MoistureState::kWet), 1);
  EXPECT_EQ(MoistureStateOf("wet"), MoistureState::kWet);
  EXPECT_EQ(MoistureStateOf("soaked"), std::nullopt);
  EXPECT_EQ(UscsName(UscsClass::kSMSC), "SM-SC");
}

TEST(MovementSpeed, WorkedExample) {
  MovementFactors factors;
  factors.slope = 0.15;
  factors.max_off_road_slope = 0.45;
  factors.max_on_road_slope = 0.60;
  factors.max_road_speed = 144 / 3.6;
  EXPECT_NEAR(MovementSpeed(factors) * 3.6, 72, 1e-9);
  factors.contour_crossings = 3;
  ExpectPrinted(MovementSpeed(factors) * 3.6 / 72, 0.946429);
  factors.soil = 0.7;
  ExpectPrinted(MovementSpeed(factors) * 3.6, 47.7, 3);
  factors.slope = 0.5;
  EXPECT_EQ(MovementSpeed(factors), 0);
}

}  // namespace
}  // namespace dbd
