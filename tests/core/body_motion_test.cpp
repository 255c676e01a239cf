#include "body_motion.h"

#include <gtest/gtest.h>

#include "support/core_engine.h"

namespace dbd {
namespace {

/// One body without forces.
class FreeBody {
 public:
  explicit FreeBody(const Eigen::Vector3d& inertia, double step)
      : step_(step), vehicle_(OneBody(inertia)), work_(vehicle_), state_(StateOfBodies(vehicle_)) {}

  void Advance(double time, double gravity = 0) {
    const auto steps = std::lround(time / step_);
    for (long i = 0; i < steps; ++i) {
      work_.R_WB[0] = RotationMatrix(body().q_WB);
      work_.wrench[0] = force;
      IntegrateBodies(vehicle_, gravity, step_, work_, state_);
    }
  }

  BodyState<double>& body() { return state_.bodies[0]; }
  double Energy() const { return KineticEnergy(vehicle_, state_); }
  void Spin(const Eigen::Vector3d& w) { SetAngularVelocity(vehicle_.bodies[0], w, body()); }

  Wrench<double> force{};

 private:
  static VehicleModel OneBody(const Eigen::Vector3d& inertia) {
    VehicleModel vehicle;
    vehicle.bodies.push_back({"body", 4, inertia, {0, 0, 0}});
    return vehicle;
  }

  double step_;
  VehicleModel vehicle_;
  Workspace<double> work_;
  EngineState<double> state_;
};

const Eigen::Vector3d kUnequal(1.0, 2.0, 2.5);

TEST(BodyMotion, FreeBodyKeepsItsMomenta) {
  FreeBody free(kUnequal, 2e-3);
  free.body().v_WB = {1, -2, 0.5};
  free.Spin({3, 1, -2});
  const Vec3<double> h = free.body().h_WB;
  free.Advance(10);
  EXPECT_EQ(ToEigen(free.body().v_WB), Eigen::Vector3d(1, -2, 0.5));
  EXPECT_EQ(ToEigen(free.body().h_WB), ToEigen(h));
  EXPECT_LT((ToEigen(free.body().p_WB) - Eigen::Vector3d(10, -20, 5)).norm(), 1e-10);
}

TEST(BodyMotion, FreeFallIsExact) {
  // With the velocity half a step behind, leapfrog reproduces a parabola to round-off: after n
  // steps of dt from v(-dt/2) = 0 the height is -g dt^2 n (n + 1) / 2.
  const double dt = 2e-3, g = 9.81;
  FreeBody free(kUnequal, dt);
  free.body().v_WB.z = g * dt / 2;  // v(0) = 0
  free.Advance(2, g);
  EXPECT_NEAR(free.body().p_WB.z, -0.5 * g * 2 * 2, 1e-10);
}

TEST(BodyMotion, ConstantTorqueTurnsASphereLikeABody) {
  FreeBody free(Eigen::Vector3d::Constant(2), 2e-3);
  free.force.t_W = {0, 0, 1};
  free.body().h_WB.z = -1 * 2e-3 / 2;  // h(0) = 0
  free.Advance(1);
  // Half a step before 1 s the rate is (1 - 0.001) / 2; the angle is t^2 / 4.
  EXPECT_NEAR(free.body().w_WB.z, 0.4995, 1e-10);
  EXPECT_NEAR(2 * std::atan2(free.body().q_WB.z, free.body().q_WB.w), 0.25, 1e-10);
}

TEST(BodyMotion, AxisymmetricBodyPrecessesAtTheAnalyticRate) {
  // Transverse moments 2, axial 1 (about z). The axis turns about h at |h| / I_t.
  const double dt = 1e-3;
  FreeBody free(Eigen::Vector3d(2, 2, 1), dt);
  free.Spin({0.6, 0, 3});
  const Eigen::Vector3d h(1.2, 0, 3);
  const Eigen::Vector3d about = h.normalized();
  const double angle = h.norm() / 2 * 2.0;  // after 2 s
  free.Advance(2);
  const Eigen::Vector3d expected = Eigen::AngleAxisd(angle, about) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis = ToEigen(RotationMatrix(free.body().q_WB).z);
  EXPECT_LT((axis - expected).norm(), 2e-5);
  EXPECT_NEAR(axis.dot(about), 3 / h.norm(), 1e-6);  // constant nutation angle
}

double EnergyError(double dt) {
  FreeBody free(kUnequal, dt);
  free.Spin({4, 5, 3});
  const double before = free.Energy();
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    free.Advance(0.04);
    worst = std::max(worst, std::abs(free.Energy() / before - 1));
  }
  return worst;
}

TEST(BodyMotion, RotationalEnergyErrorIsSmallAndOfSecondOrder) {
  const double coarse = EnergyError(4e-3), fine = EnergyError(2e-3);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(coarse / fine, 4, 1.2);
}

TEST(BodyMotion, IntermediateAxisTumbles) {
  // Rotation about the middle moment is unstable: a small disturbance grows until the body turns
  // over, while the momentum stays.
  FreeBody free(kUnequal, 1e-3);
  free.Spin({1e-3, 5, 0});
  double least = 1;
  for (int i = 0; i < 400; ++i) {
    free.Advance(0.02);
    least = std::min(least, RotationMatrix(free.body().q_WB).y.y);
  }
  EXPECT_LT(least, -0.9);
}

TEST(BodyMotion, AttitudeStaysNormalised) {
  FreeBody free(kUnequal, 4e-3);
  free.Spin({20, -15, 30});
  free.Advance(20);
  const Quat<double>& q = free.body().q_WB;
  EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-14);
}

}  // namespace
}  // namespace dbd
