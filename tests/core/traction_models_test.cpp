#include "traction_models.h"

#include <dbd/core/mobility.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/traction_relations.h>

#include <gtest/gtest.h>

#include "pack.h"
#include "soil_rule.h"
#include "support/core_tire.h"
#include "support/core_vehicle.h"
#include "tire_force.h"
#include "tire_pattern.h"

namespace dbd {
namespace {

const BekkerSoil kSand{0.793, 102e3, 5301e3, 1300, 0.5428, 0.012};

SoilSample SoilOf(TractionModel model) { return {300e3, 0.88, model, kSand}; }

/// What the low-speed damper adds to a slip of 0.2 at 5 m/s: u - v = 1.25 m/s.
const double kDamped = kBristleTime / 0.3 / (1 + 25 / (kBristleSpeed * kBristleSpeed)) * 1.25;

/// A rear wheel of the TM27 that rolls at 5 m/s with a given slip, steady.
struct RollingWheel {
  RollingWheel(const SoilSample& soil, double load, double slip) {
    const TireModel& tire = model.tire;
    wheel.contact.normal_W = {0, 0, 1};
    wheel.contact.p_HC_W = {0, 0, -0.32};
    wheel.contact.deflection = load / tire.stiffness;
    wheel.contact.cone_index = soil.cone_index;
    wheel.contact.friction_limit = soil.friction_limit;
    wheel.contact.rule =
        MakeSoilRule<double>(&soil, MakeTirePattern(tire).size, wheel.contact.deflection);
    body.q_WB = {1, 0, 0, 0};
    body.v_WB.x = 5;
    wheel.spin = (slip > 0 ? 5 / (1 - slip) : 5 * (1 + slip)) / Law().rolling_radius;
    wheel.slip = slip;
  }
  TireLaw<double> Law() { return EvaluateTire(model.tire, body, 2e-3, wheel); }

  WheelModel model = Tm27().wheels[0];
  BodyState<double> body{};
  WheelState<double> wheel{};
};

using Pack2 = Pack<double, 2>;

Pack2 Both(double first, double second) {
  const double lanes[2] = {first, second};
  return LaneTraits<Pack2>::Load(lanes);
}

TEST(TractionModels, BrixiusIsUntouchedByOtherLanes) {
  const TireNumbers<double> tire = MakeTireNumbers(Tm27().wheels[0].tire, 2e-3);
  TireContact<Pack2> contact{};
  contact.cone_index = Pack2(300e3);
  contact.rule.model = Both(0, 2);
  contact.rule.capacity = Both(0, 0.5);
  contact.rule.shear_rate = Both(0, 10);
  TractionCurve<Pack2> curve = BrixiusCurve(tire.traction, Pack2(20), Pack2(0.1));
  SelectTractionModel(tire, contact, Pack2(2000), curve);
  const TractionCurve<double> alone = BrixiusCurve(tire.traction, 20.0, 0.1);
  EXPECT_DOUBLE_EQ(curve.capacity.v[0], alone.capacity);
  EXPECT_DOUBLE_EQ(curve.rate.v[0], alone.rate);
  EXPECT_DOUBLE_EQ(curve.resistance.v[0], alone.resistance);
  EXPECT_DOUBLE_EQ(curve.carcass.v[0], alone.carcass);
  const ShearForce<Pack2> shear = ShearAt(curve, Pack2(1000), Pack2(0.1));
  EXPECT_DOUBLE_EQ(shear.force.v[0], ShearAt(alone, 1000.0, 0.1).force);
  EXPECT_DOUBLE_EQ(shear.stiffness.v[0], ShearAt(alone, 1000.0, 0.1).stiffness);
  EXPECT_DOUBLE_EQ(curve.capacity.v[1], 0.5);
  EXPECT_DOUBLE_EQ(curve.janosi.v[1], 1);
}

TEST(TractionModels, WismerLuthOfTheEngineIsThePublishedOne) {
  const double load = 2238.773, slip = 0.2;
  const TireLaw<double> law = RollingWheel(SoilOf(TractionModel::kWismerLuth), load, slip).Law();
  const double numeric = WheelNumeric(300e3, load, 0.3048, 0.6604);
  const TractionRatios ratios = WismerLuthTraction(numeric, slip);
  EXPECT_NEAR(law.traction0 / load, WismerLuthTraction(numeric, slip + kDamped).gross, 1e-3);
  EXPECT_NEAR(-law.resistance / load, ratios.resistance, 1e-3 * ratios.resistance);
  EXPECT_EQ(law.carcass_torque, 0);
}

TEST(TractionModels, BekkerOfTheEngineIsThePublishedOne) {
  const double load = 2238.773, slip = 0.2;
  RollingWheel wheel(SoilOf(TractionModel::kBekker), load, slip);
  const TireLaw<double> law = wheel.Law();
  const double deflection = load / wheel.model.tire.stiffness;
  const BekkerWheelForces forces = BekkerWheel(kSand, {load, 0.3048, 0.6604, deflection});
  const double area = 0.3048 * forces.contact_length;
  const auto thrust = [&](double s) {
    return JanosiThrust(kSand, area, load, forces.contact_length, s);
  };
  EXPECT_NEAR(law.traction_limit, thrust(1), 1e-9);
  EXPECT_NEAR(law.traction0, thrust(slip + kDamped), 1e-3 * load);
  EXPECT_NEAR(-law.resistance, forces.resistance, 1e-3 * forces.resistance);
}

TEST(TractionModels, ContinuousAtSlipZeroAndLoadZero) {
  for (const auto model : {TractionModel::kWismerLuth, TractionModel::kBekker}) {
    EXPECT_NEAR(RollingWheel(SoilOf(model), 2000, 1e-9).Law().traction0,
                RollingWheel(SoilOf(model), 2000, -1e-9).Law().traction0, 1e-4);
    for (const double load : {1.0, 1e-3, 1e-6}) {
      const TireLaw<double> law = RollingWheel(SoilOf(model), load, 0.3).Law();
      EXPECT_LE(std::abs(law.traction0), 0.89 * load);
      EXPECT_LE(std::abs(law.resistance), load);
    }
    EXPECT_EQ(RollingWheel(SoilOf(model), 0, 0.3).Law().traction0, 0);
  }
}

TEST(TractionModels, TractionGrowsWithSlipAndItsSlopeIsTheDerivative) {
  for (const auto model :
       {TractionModel::kBrixius, TractionModel::kWismerLuth, TractionModel::kBekker}) {
    const TractionCurve<double> curve = RollingWheel(SoilOf(model), 2000, 0.1).Law().curve;
    double last = -1;
    for (double slip = 0; slip < 1; slip += 0.01) {
      const ShearForce<double> here = ShearAt(curve, 1000.0, slip);
      EXPECT_GT(here.force, last);
      last = here.force;
      const double h = 1e-6;
      const double slope =
          (ShearAt(curve, 1000.0, slip + h).force - ShearAt(curve, 1000.0, slip).force) / h;
      EXPECT_NEAR(here.stiffness, slope, 1e-3 * here.stiffness + 0.05);
    }
  }
}

TEST(TractionModels, VehicleMobilityFollowsTheModel) {
  const double brixius = MaxNetTractionRatio(Tm27(), SoilOf(TractionModel::kBrixius));
  for (const auto model : {TractionModel::kWismerLuth, TractionModel::kBekker}) {
    const double other = MaxNetTractionRatio(Tm27(), SoilOf(model));
    EXPECT_GT(other, 0);
    EXPECT_NE(other, brixius);
    EXPECT_LT(MaxNetTractionRatio(Tm27(), {300e3, 0.1, model, kSand}), other);
  }
  EXPECT_EQ(StaticSinkage(Tm27(), SoilOf(TractionModel::kWismerLuth)),
            StaticSinkage(Tm27(), SoilOf(TractionModel::kBrixius)));
  EXPECT_NE(StaticSinkage(Tm27(), SoilOf(TractionModel::kBekker)),
            StaticSinkage(Tm27(), SoilOf(TractionModel::kBrixius)));
}

}  // namespace
}  // namespace dbd
