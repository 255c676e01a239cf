#include <dbd/core/bekker.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "janosi_share.h"
#include "pack.h"
#include "support/core_printed.h"
#include "support/core_test_tires.h"

namespace dbd {
namespace {

BekkerSoil Soil(double n, double kc_kn, double kphi_kn, double c_kpa, double phi_deg, double k) {
  return {n, kc_kn * 1e3, kphi_kn * 1e3, c_kpa * 1e3, Degrees(phi_deg), k};
}
const BekkerSoil kDrySand = Soil(1.1, 0.99, 1528.43, 1.04, 28, 0.025);
const BekkerSoil kSandyLoam = Soil(0.7, 5.27, 1515.04, 1.72, 29, 0.02);
const BekkerSoil kLeteSand = Soil(0.793, 102, 5301, 1.3, 31.1, 0.012);
const BekkerSoil kClayey = Soil(0.5, 13.19, 692.15, 4.14, 13, 0.02);
const BekkerSoil kNorthGower = Soil(0.73, 41.6, 2471, 6.1, 26.6, 0.02);
const BekkerSoil kLeanClay = Soil(0.15, 1.52, 119.61, 13.79, 11, 0.03);

TEST(Bekker, PlateSinkageWorkedExamples) {
  const std::pair<BekkerSoil, double> rows[] = {{kDrySand, 0.0525889},
                                                {kLeteSand, 0.00325268},
                                                {kClayey, 0.00665620},
                                                {kNorthGower, 0.00570254}};
  for (const auto& [soil, sinkage] : rows) {
    ExpectPrinted(BekkerSinkage(soil, 0.3048, 60e3), sinkage);
    EXPECT_NEAR(BekkerPressure(soil, 0.3048, BekkerSinkage(soil, 0.3048, 60e3)), 60e3, 1e-6);
  }
}

TEST(Bekker, RigidWheelWorkedExamples) {
  const struct {
    BekkerSoil soil;
    double sinkage, resistance;
  } rows[] = {{kDrySand, 0.0535659, 476.024},
              {kLeteSand, 0.00869377, 193.365},
              {kNorthGower, 0.0124695, 233.351}};
  for (const auto& row : rows) {
    const double z = RigidWheelSinkage(row.soil, kT3.load, kT3.width, kT3.diameter);
    ExpectPrinted(z, row.sinkage);
    ExpectPrinted(CompactionResistance(row.soil, kT3.width, z), row.resistance);
  }
}

TEST(Bekker, ShearWorkedExamples) {
  ExpectPrinted(ShearStress(kDrySand, 60e3, 0.02) / 1e3, 18.1405);
  ExpectPrinted(ShearStress(kLeteSand, 60e3, 0.02) / 1e3, 30.4126);
  ExpectPrinted(JanosiThrust(kLeteSand, 0.06096, 2223, 0.2, 0.2) / 1e3, 1.00937);
}

TEST(Bekker, ThrustIsOddAndContinuousInSlip) {
  const auto thrust = [](double slip) { return JanosiThrust(kClayey, 0.06, 2223, 0.2, slip); };
  EXPECT_EQ(thrust(0), 0);
  for (const double slip : {1e-12, 1e-6, 0.01, 0.3, 1.0}) EXPECT_EQ(thrust(-slip), -thrust(slip));
  double last = -1e9;
  for (double slip = -1; slip <= 1; slip += 1e-3) {
    EXPECT_GT(thrust(slip), last);
    last = thrust(slip);
  }
}

TEST(Bekker, SharesSeriesMeetsTheClosedForm) {
  const double below = 0.1 - 1e-9, above = 0.1 + 1e-9;
  EXPECT_NEAR(JanosiShare(below), JanosiShare(above), 1e-8);
  for (const double x : {0.0, 0.01, 0.0999, 0.1001, 1.0, 20.0}) {
    const double h = 1e-5;
    const double least = std::max(x - h, 0.0);
    const double slope = (JanosiShare(x + h) - JanosiShare(least)) / (x + h - least);
    EXPECT_NEAR(JanosiShareOf(x).slope, slope, 3e-6) << x;
  }
}

using Pack2 = Pack<double, 2>;

Pack2 Both(double first, double second) {
  const double lanes[2] = {first, second};
  return LaneTraits<Pack2>::Load(lanes);
}

TEST(Bekker, LanesOfAPackDoNotTouchEachOther) {
  const auto pack = JanosiShareOf(Both(0.03, 5.0));
  EXPECT_DOUBLE_EQ(pack.share.v[0], JanosiShareOf(0.03).share);
  EXPECT_DOUBLE_EQ(pack.share.v[1], JanosiShareOf(5.0).share);
  EXPECT_DOUBLE_EQ(pack.slope.v[0], JanosiShareOf(0.03).slope);
  EXPECT_DOUBLE_EQ(pack.slope.v[1], JanosiShareOf(5.0).slope);
}

TEST(BekkerWheel, EverythingVanishesWithTheLoad) {
  for (const BekkerSoil& soil : {kDrySand, kClayey, kLeanClay}) {
    double last = 1e9;
    for (double load = 3000; load > 1e-6; load /= 10) {
      const BekkerWheelForces forces = BekkerWheel(soil, {load, 0.3048, 0.6604, load / 75e3});
      EXPECT_LT(forces.resistance + forces.shear_strength, last);
      EXPECT_LT(forces.resistance, load);
      last = forces.resistance + forces.shear_strength;
    }
    EXPECT_LT(last, 1.0);
    EXPECT_EQ(BekkerWheel(soil, {0, 0.3048, 0.6604, 0}).resistance, 0);
  }
}

TEST(BekkerWheel, SinksNoDeeperThanARigidWheelOrItsPatch) {
  // Patch: L = 2 sqrt(0.3302 * 0.02964) = 0.197859, p = 2223/(0.3048 L) = 36.8611 kPa.
  const BekkerWheelInput wheel{kT3.load, kT3.width, kT3.diameter, kT3Deflection};
  for (const BekkerSoil& soil : {kDrySand, kLeteSand, kClayey, kNorthGower}) {
    const BekkerWheelForces forces = BekkerWheel(soil, wheel);
    EXPECT_NEAR(forces.contact_length, 0.197859, 1e-6);
    const double patch = BekkerSinkage(soil, kT3.width, 36861.1);
    const double rigid = RigidWheelSinkage(soil, kT3.load, kT3.width, kT3.diameter);
    EXPECT_NEAR(forces.sinkage, std::min(patch, rigid), 1e-6);
    const double strength = kT3.width * forces.contact_length * soil.cohesion +
                            kT3.load * std::tan(soil.friction_angle);
    EXPECT_NEAR(forces.shear_strength, strength, 1e-9);
  }
}

TEST(BekkerWheel, SofterTiresSinkLess) {
  double last = 0;
  for (double stiffness = 30e3; stiffness < 5e5; stiffness *= 1.5) {
    const BekkerWheelForces forces =
        BekkerWheel(kDrySand, {2223, 0.3048, 0.6604, 2223 / stiffness});
    EXPECT_GE(forces.sinkage, last);
    last = forces.sinkage;
  }
}

TEST(BekkerConeIndex, WorkedExamples) {
  const struct {
    BekkerSoil soil;
    double surface, three, six, mean, mean_kpa;
  } rows[] = {{kDrySand, 1.94916, 15.6686, 30.8754, 15.9863, 110.222},
              {kSandyLoam, 13.5702, 52.2473, 80.1784, 50.0304, 344.948},
              {kLeteSand, 81.0779, 326.289, 524.665, 316.490, 2182.12},
              {kClayey, 33.7669, 84.8183, 114.515, 80.4888, 554.951},
              {kLeanClay, 19.3929, 26.2530, 28.7466, 25.4132, 175.218}};
  for (const auto& row : rows) {
    ExpectPrinted(ConeIndexFromBekker(row.soil, 0) / Psi(1), row.surface);
    ExpectPrinted(ConeIndexFromBekker(row.soil, Inches(3)) / Psi(1), row.three);
    ExpectPrinted(ConeIndexFromBekker(row.soil, Inches(6)) / Psi(1), row.six);
    ExpectPrinted(MeanConeIndexFromBekker(row.soil) / Psi(1), row.mean);
    ExpectPrinted(MeanConeIndexFromBekker(row.soil) / 1e3, row.mean_kpa);
  }
}

}  // namespace
}  // namespace dbd
