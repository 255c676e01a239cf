#include "wheel_spin.h"

#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

constexpr double kStep = 2e-3;
constexpr double kHeldFast = 1e12;  // inertia of a carrier that nothing turns [kg m^2]
constexpr double kAtRest = 1e-11;   // what the brake's impulse leaves of it [rad/s]

/// The TM27's wheels in the air: no traction, only drive, brakes and differentials.
class SpinsInTheAir : public ::testing::Test {
 protected:
  SpinsInTheAir() : state(StateOfBodies(Tm27())) {
    state.wheels.assign(4, WheelState<double>{});
    laws.fill(TireLaw<double>{});
    carriers.fill({0, kHeldFast});
  }

  void Advance(int steps = 1) {
    const EngineModel engine(vehicle);
    for (int i = 0; i < steps; ++i) {
      AdvanceSpins(engine, controls, kStep, laws, carriers, state, change, brake_torque);
    }
  }
  double Momentum() const {
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += vehicle.wheels[i].spin_inertia * state.wheels[i].spin;
    return sum;
  }

  VehicleModel vehicle = Tm27();
  EngineState<double> state;
  WheelControls<double> controls{};
  std::array<TireLaw<double>, kMaxWheels> laws{};
  std::array<CarrierSpin<double>, kMaxWheels> carriers{};
  SpinArray<double> change{}, brake_torque{};
};

TEST_F(SpinsInTheAir, DriveTorqueSpinsUpExactly) {
  controls.drive_torque[0] = 80;
  Advance(500);
  EXPECT_NEAR(state.wheels[0].spin, 80 * 1.0 / 1.6, 1e-9);  // T t / J
  EXPECT_EQ(state.wheels[1].spin, 0);
}

TEST_F(SpinsInTheAir, BrakeHoldsExactlyAtRestAndNeverReverses) {
  controls.brake_torque[0] = 900;
  state.wheels[0].spin = 3;
  // 900 N m take 3 rad/s off 1.6 kg m2 in 5.3 ms: the third step stops it.
  Advance(2);
  EXPECT_GT(state.wheels[0].spin, 0);
  Advance();
  EXPECT_NEAR(state.wheels[0].spin, 0, kAtRest);
  Advance(5);
  EXPECT_NEAR(state.wheels[0].spin, 0, kAtRest);
  controls.drive_torque[0] = 500;  // less than the brake
  Advance(5);
  EXPECT_NEAR(state.wheels[0].spin, 0, kAtRest);
  EXPECT_NEAR(brake_torque[0], -500, 1e-6);
  controls.drive_torque[0] = 1000;
  Advance();
  EXPECT_NEAR(state.wheels[0].spin, (1000 - 900) * kStep / 1.6, kAtRest);
}

TEST_F(SpinsInTheAir, BrakeOpposesBothDirections) {
  controls.brake_torque[0] = controls.brake_torque[1] = 100;
  state.wheels[0].spin = 10, state.wheels[1].spin = -10;
  Advance(100);
  EXPECT_NEAR(state.wheels[0].spin, -state.wheels[1].spin, 1e-12);
  EXPECT_NEAR(state.wheels[0].spin, 0, kAtRest);  // 100 N m * 0.2 s > 1.6 * 10
}

/// A carrier that may turn takes up what the brake takes off the wheel: both end with one rate.
TEST_F(SpinsInTheAir, BrakeHoldsTheWheelToItsCarrierNotToTheWorld) {
  controls.brake_torque[0] = 5000;
  carriers[0] = {-2, 1};
  state.wheels[0].spin = 3;
  Advance();
  const double together = (1.6 * 3 - 1 * 2) / (1.6 + 1);
  EXPECT_NEAR(state.wheels[0].spin, together, 1e-12);
  // The reaction brings the carrier to the same rate: -torque dt / I.
  EXPECT_NEAR(-2 - brake_torque[0] * kStep / 1, together, 1e-12);
}

TEST_F(SpinsInTheAir, BothWheelsOfASolidAxleEndWithItsRate) {
  vehicle.wheels[1].body = vehicle.wheels[0].body;
  controls.brake_torque[0] = controls.brake_torque[1] = 5000;
  carriers[0] = carriers[1] = {0.5, 0.5 * 6};  // half of the axle's 6 kg m2 each
  state.wheels[0].spin = 4, state.wheels[1].spin = -1;
  Advance();
  const double together = (1.6 * (4 - 1) + 6 * 0.5) / (1.6 + 1.6 + 6);
  EXPECT_NEAR(state.wheels[0].spin, together, 1e-12);
  EXPECT_NEAR(state.wheels[1].spin, together, 1e-12);
  EXPECT_NEAR(0.5 - (brake_torque[0] + brake_torque[1]) * kStep / 6, together, 1e-12);
}

TEST_F(SpinsInTheAir, OpenDifferentialLeavesTheSpeedsAlone) {
  state.wheels[0].spin = 12, state.wheels[1].spin = 4;
  Advance(10);
  EXPECT_EQ(state.wheels[0].spin, 12);
  EXPECT_EQ(state.wheels[1].spin, 4);
}

TEST_F(SpinsInTheAir, LockedDifferentialEqualisesAndConservesMomentum) {
  vehicle.axles[0].differential.type = DifferentialType::kLocked;
  vehicle.wheels[1].spin_inertia = 3.2;
  state.wheels[0].spin = 12, state.wheels[1].spin = 3;
  const double before = Momentum();
  Advance();
  EXPECT_NEAR(state.wheels[0].spin, (1.6 * 12 + 3.2 * 3) / 4.8, 1e-12);
  EXPECT_NEAR(state.wheels[1].spin, state.wheels[0].spin, 1e-12);
  EXPECT_NEAR(Momentum(), before, 1e-12);
}

TEST_F(SpinsInTheAir, LimitedSlipMovesNoMoreThanItsBias) {
  vehicle.axles[0].differential = {DifferentialType::kLimitedSlip, 200};
  state.wheels[0].spin = 12, state.wheels[1].spin = 4;
  Advance();
  EXPECT_NEAR(state.wheels[0].spin, 12 - 200 * kStep / 1.6, 1e-12);
  EXPECT_NEAR(state.wheels[1].spin, 4 + 200 * kStep / 1.6, 1e-12);
  Advance(100);  // in the end it holds the speeds together
  EXPECT_NEAR(state.wheels[0].spin, 8, 1e-9);
  EXPECT_NEAR(state.wheels[1].spin, 8, 1e-9);
}

TEST_F(SpinsInTheAir, LockedCentreCouplesTheMeansOfDrivenAxles) {
  vehicle.axles[1].driven = true;
  vehicle.powertrain.centre.type = DifferentialType::kLocked;
  state.wheels[0].spin = 12, state.wheels[1].spin = 8;
  state.wheels[2].spin = 2, state.wheels[3].spin = 6;
  const double before = Momentum();
  Advance();
  EXPECT_NEAR(state.wheels[0].spin + state.wheels[1].spin,
              state.wheels[2].spin + state.wheels[3].spin, 1e-12);
  EXPECT_NEAR(state.wheels[0].spin - state.wheels[1].spin, 4, 1e-12);  // open within the axle
  EXPECT_NEAR(Momentum(), before, 1e-12);
}

TEST_F(SpinsInTheAir, TractionActsAgainstTheSpinSemiImplicitly) {
  // (J + dt r T') dw = dt (T - r T0): r = 0.3, T0 = 400, T' = 1000, drive 200:
  // (1.6 + 0.002 * 0.3 * 1000) dw = 0.002 * (200 - 120) -> dw = 0.16 / 2.2.
  laws[0].rolling_radius = 0.3;
  laws[0].traction0 = 400;
  laws[0].traction_by_spin = 1000;
  controls.drive_torque[0] = 200;
  Advance();
  EXPECT_NEAR(change[0], 0.16 / 2.2, 1e-12);
}

TEST(WheelSpin, CouplingTorqueOfEachType) {
  EXPECT_EQ(CouplingTorque({DifferentialType::kOpen, 50}), 0);
  EXPECT_EQ(CouplingTorque({DifferentialType::kLimitedSlip, 50}), 50);
  EXPECT_GE(CouplingTorque({DifferentialType::kLocked, 50}), 1e5);
}

}  // namespace
}  // namespace dbd
