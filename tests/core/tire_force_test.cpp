#include "tire_force.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/core_engine.h"
#include "support/core_tire.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

constexpr double kStep = 2e-3;

/// A rear wheel of the TM27 held in a given contact and motion.
struct HeldWheel {
  explicit HeldWheel(double load = 2238.773) {
    wheel.contact.normal_W = {0, 0, 1};
    wheel.contact.p_HC_W = {0, 0, -0.32};
    wheel.contact.deflection = load / model.tire.stiffness;
    wheel.contact.cone_index = 300e3;
    wheel.contact.friction_limit = 0.88;
    body.q_WB = {1, 0, 0, 0};
  }

  TireLaw<double> Law() { return EvaluateTire(model.tire, body, kStep, wheel); }

  /// Lets slip and slip angle build up at the present speeds.
  TireLaw<double> Steady() {
    TireLaw<double> law = Law();
    for (int i = 0; i < 3000; ++i) {
      wheel.slip = law.slip_base + law.slip_gain * wheel.spin;
      law = Law();
    }
    return law;
  }

  WheelModel model = Tm27().wheels[0];
  BodyState<double> body{};
  WheelState<double> wheel{};
};

TEST(TireForce, LoadIsStiffnessTimesDeflectionPlusDamping) {
  HeldWheel w(2000);
  EXPECT_NEAR(w.Law().load, 2000, 1e-9);
  w.body.v_WB.z = -0.2;  // 500 N s/m * 0.2 m/s
  EXPECT_NEAR(w.Law().load, 2100, 1e-9);
  w.body.v_WB.z = 10;  // rebounds faster than the tire: never pulls
  EXPECT_EQ(w.Law().load, 0);
}

TEST(TireForce, DeflectionFollowsTheHubBetweenSamples) {
  HeldWheel w(2000);
  w.body.p_WB.z = -1e-3;  // 235.152 N more
  EXPECT_NEAR(w.Law().load, 2000 + 1e-3 * w.model.tire.stiffness, 1e-9);
  w.body.p_WB.z = 1;
  EXPECT_EQ(w.Law().load, 0);
}

TEST(TireForce, EverythingVanishesContinuouslyWithTheLoad) {
  double last_limit = 1e9, last_lateral = 1e9;
  for (const double load : {1000.0, 100.0, 10.0, 1.0, 0.1, 1e-3, 1e-6}) {
    HeldWheel w(load);
    w.body.v_WB = {5, 1, 0};
    w.wheel.spin = 20;
    const TireLaw<double> law = w.Steady();
    EXPECT_LE(std::abs(law.traction0), load);
    EXPECT_LE(std::abs(law.lateral), load);
    EXPECT_LE(std::abs(law.resistance), 0.3 * load);
    EXPECT_LT(law.traction_limit, last_limit);
    EXPECT_LT(std::abs(law.lateral), last_lateral);
    last_limit = law.traction_limit, last_lateral = std::abs(law.lateral);
  }
}

/// Largest change of traction, lateral force or resistance between neighbours of a sweep.
double LargestJump(const std::function<HeldWheel(double)>& at, double begin, double end) {
  constexpr int kCount = 2000;
  double worst = 0;
  TireLaw<double> last{};
  for (int i = 0; i <= kCount; ++i) {
    HeldWheel w = at(begin + (end - begin) * i / kCount);
    const TireLaw<double> law = w.Law();
    if (i > 0) {
      worst = std::max({worst, std::abs(law.traction0 - last.traction0),
                        std::abs(law.lateral - last.lateral),
                        std::abs(law.resistance - last.resistance)});
    }
    last = law;
  }
  return worst;
}

// A sweep through standstill, slip zero and the first touch changes no force by more than a small
// share of the load of 2239 N from one of 2000 places to the next.
TEST(TireForce, ContinuousThroughStandstillSlipZeroAndLiftOff) {
  const auto speed = [](double vx) {
    HeldWheel w;
    w.body.v_WB = {vx, 0.3 * vx, 0};
    w.wheel.slip = 0.1, w.wheel.slip_angle = 0.05;
    return w;
  };
  EXPECT_LT(LargestJump(speed, -0.5, 0.5), 10);
  const auto spin = [](double slip) {
    HeldWheel w;
    w.body.v_WB.x = 3;
    w.wheel.spin = 3 / (0.3244 * (1 - slip));
    w.wheel.slip = slip;
    return w;
  };
  EXPECT_LT(LargestJump(spin, -0.3, 0.3), 10);
  const auto height = [](double up) {
    HeldWheel w;
    w.body.p_WB.z = up;
    w.body.v_WB = {3, 0.3, 0};
    w.wheel.spin = 12, w.wheel.slip_angle = 0.1;
    return w;
  };
  EXPECT_LT(LargestJump(height, -0.01, 0.02), 10);  // it leaves the ground at 9.5 mm
}

TEST(TireForce, InTheAirThereIsNoForceAndSlipIsForgotten) {
  HeldWheel w(0);
  w.body.v_WB = {5, 1, 0};
  w.wheel.slip_angle = 0.3;
  const TireLaw<double> law = w.Law();
  EXPECT_EQ(law.load, 0);
  EXPECT_EQ(law.traction0, 0);
  EXPECT_EQ(law.lateral, 0);
  EXPECT_EQ(law.resistance, 0);
  EXPECT_EQ(w.wheel.slip_angle, 0);
}

TEST(TireForce, SteadyTractionFollowsBrixius) {
  HeldWheel w;
  w.body.v_WB.x = 5;
  const double radius = w.Law().rolling_radius;
  for (const double slip : {-0.3, -0.1, 0.05, 0.1, 0.2, 0.4}) {
    // Driving s = 1 - v/u, braking s = u/v - 1.
    w.wheel.spin = (slip > 0 ? 5 / (1 - slip) : 5 * (1 + slip)) / radius;
    w.wheel.slip = 0;
    const TireLaw<double> law = w.Steady();
    EXPECT_NEAR(w.wheel.slip, slip, 1e-6);
    const double shear = law.traction_limit * (1 - std::exp(-7.5 * std::abs(slip)));
    // The low-speed damper adds little at 5 m/s: 0.02 / 0.3 / (1 + 25) of the speed difference.
    EXPECT_NEAR(law.traction0, std::copysign(shear, slip), 0.05 * law.traction_limit);
    EXPECT_GT(law.traction0 * slip, 0);
  }
}

TEST(TireForce, SlopeAgainstSpinIsTheDerivativeOfTheTraction) {
  for (const double spin : {14.0, 16.0, 20.0}) {
    HeldWheel w;
    w.body.v_WB.x = 5;
    w.wheel.spin = spin;
    w.wheel.slip = 0.05;
    const TireLaw<double> law = w.Law();
    // Speed in the relaxation is held over the step; only the wheel's own speed varies.
    const double h = 1e-6;
    const auto shear = [&](double s) {
      const double low = 5.0 / kBristleSpeed;
      const double damper = kBristleTime / w.model.tire.relaxation_length / (1 + low * low);
      const double slip = law.slip_base + law.slip_gain * s + damper * (s * law.rolling_radius - 5);
      return std::copysign(law.traction_limit * (1 - std::exp(-7.5 * std::abs(slip))), slip);
    };
    EXPECT_NEAR(law.traction0, shear(spin), 1e-9);
    EXPECT_NEAR(law.traction_by_spin, (shear(spin + h) - shear(spin - h)) / (2 * h), 1e-3);
    EXPECT_GE(law.traction_by_spin, 0);
  }
}

TEST(TireForce, LateralForceOpposesTheSideMotion) {
  for (const double vy : {-2.0, -0.1, 0.1, 2.0}) {
    HeldWheel w;
    w.body.v_WB = {5, vy, 0};
    w.wheel.spin = 5 / w.Law().rolling_radius;
    EXPECT_LT(w.Steady().lateral * vy, 0) << vy;
  }
}

TEST(TireForce, SteadySlipAngleIsTheRatioOfSpeeds) {
  HeldWheel w;
  w.body.v_WB = {5, 0.5, 0};
  w.wheel.spin = 5 / w.Law().rolling_radius;
  const TireLaw<double> law = w.Steady();
  EXPECT_NEAR(w.wheel.slip_angle, 0.1, 1e-9);
  // 0.8 / 0.88 of the capacity, 1 - e^(-7 * angle); the damper adds 0.04/0.3/26 * 0.5 = 0.00256.
  const double expected = 0.8 / 0.88 * law.traction_limit * (1 - std::exp(-7 * 0.10256));
  EXPECT_NEAR(-law.lateral, expected, 0.002 * expected);
}

TEST(TireForce, TractionUsesUpTheLateralForce) {
  const auto lateral_at = [](double slip) {
    HeldWheel w;
    w.body.v_WB = {5, 0.5, 0};
    w.wheel.spin = 5 / (1 - slip) / w.Law().rolling_radius;
    w.wheel.slip = slip;
    const TireLaw<double> law = w.Steady();
    return std::pair(std::abs(law.lateral), law.traction0 / law.traction_limit);
  };
  const auto [free, no_use] = lateral_at(0);
  EXPECT_NEAR(no_use, 0, 1e-3);
  for (const double slip : {0.05, 0.1, 0.2, 0.3}) {
    const auto [lateral, use] = lateral_at(slip);
    EXPECT_NEAR(lateral / free, std::sqrt(1 - use * use), 0.002) << slip;
  }
}

TEST(TireForce, ResistanceOpposesRollingAndVanishesAtRest) {
  HeldWheel w;
  EXPECT_EQ(w.Law().resistance, 0);
  w.body.v_WB.x = 3;
  EXPECT_LT(w.Law().resistance, 0);
  EXPECT_GT(w.Law().carcass_torque, 0);
  const double forward = w.Law().resistance;
  w.body.v_WB.x = -3;
  EXPECT_NEAR(w.Law().resistance, -forward, 1e-12);
  // At speed: m1 / Bn of the load without slip, the tanh-like transition complete within 0.1 %.
  EXPECT_NEAR(-forward,
              2238.773 / MobilityNumberOf(w.model.tire, 300e3, 2238.773, 2238.773 / 235152.0), 2);
}

TEST(TireForce, SlipperyGroundLimitsTraction) {
  HeldWheel w;
  w.wheel.contact.friction_limit = 0.2;
  EXPECT_NEAR(w.Law().traction_limit, 0.2 * 2238.773, 1e-9);
}

TEST(TireForce, ContactFrameFollowsTheGround) {
  HeldWheel w;
  w.wheel.contact.normal_W = FromEigen(Eigen::Vector3d(-0.3, 0, 1).normalized());
  const TireLaw<double> law = w.Law();
  EXPECT_NEAR(Dot(law.forward_W, law.normal_W), 0, 1e-15);
  EXPECT_GT(law.forward_W.z, 0);  // uphill
  EXPECT_NEAR(law.left_W.y, 1, 1e-15);
}

TEST(TireForce, PitchingOfTheHubsBodyAboutTheSpinAxisIsNotSlip) {
  HeldWheel w;
  w.body.w_WB = {0, 2, 0};
  const Vec3<double> v = ContactVelocity(w.body, {0, 0, 0}, {0, 1, 0}, w.wheel.contact.p_HC_W);
  EXPECT_EQ(ToEigen(v), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace dbd
