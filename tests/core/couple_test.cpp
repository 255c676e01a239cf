#include "couple.h"

#include <gtest/gtest.h>

#include "body_motion.h"
#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// A rigid box of 750 kg, 3 m long and 1.8 m wide, reference frame on the ground.
VehicleModel Box() {
  VehicleModel box;
  box.bodies.push_back({"chassis", 750, {200, 500, 600}, {0, 0, 0.5}});
  box.outline = {1.5, 1.5, 0.9, 1.5, 0.3};
  return box;
}

Couple BoxCouple() {
  const BumperModel bumper{.stiffness = 1e5, .damping = 2e3, .height = 0.6};
  return {Bumpers(Box(), bumper.height), Bumpers(Box(), bumper.height), bumper, false, {}};
}

BodyState<double> At(double x, double y = 0, double yaw = 0) {
  BodyState<double> body{};
  body.p_WB = {x, y, 0.5};
  body.q_WB = {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
  return body;
}

/// Sum of both wrenches' forces, and of their moments about the origin.
void ExpectNoResultant(const CoupleForces& c, const BodyState<double>& ahead,
                       const BodyState<double>& behind) {
  const Vec3<double> f = c.on_ahead.f_W + c.on_behind.f_W;
  const Vec3<double> t = c.on_ahead.t_W + c.on_behind.t_W + Cross(ahead.p_WB, c.on_ahead.f_W) +
                         Cross(behind.p_WB, c.on_behind.f_W);
  EXPECT_EQ(Norm(f), 0);
  EXPECT_NEAR(Norm(t), 0, 1e-9 * (1 + Norm(c.on_ahead.f_W)));
}

TEST(Bumpers, ForceByHand) {
  // Pressed in by 3.0 - 2.98 = 0.02 m at rest: three points of 1e5 N/m, 6,000 N.
  const CoupleForces c = EvaluateCouple(BoxCouple(), At(2.98), At(0));
  EXPECT_NEAR(c.bumper, 6000, 1e-6);
  EXPECT_NEAR(c.on_ahead.f_W.x, 6000, 1e-6);
  EXPECT_NEAR(c.on_behind.f_W.x, -6000, 1e-6);
  // 0.1 m above the centres of mass: nose up behind, -0.1 m * 6,000 N about y.
  EXPECT_NEAR(c.on_behind.t_W.y, -600, 1e-6);
  EXPECT_NEAR(c.on_ahead.t_W.z, 0, 1e-9);
  EXPECT_EQ(EvaluateCouple(BoxCouple(), At(3.001), At(0)).bumper, 0);
}

TEST(Bumpers, DamperAtMostDoublesAndNeverPulls) {
  BodyState<double> behind = At(0);
  behind.v_WB.x = 0.5;  // elastic 1,000 N per point, damper 1,000 N
  EXPECT_NEAR(EvaluateCouple(BoxCouple(), At(2.99), behind).bumper, 6000, 1e-6);
  behind.v_WB.x = 5;
  EXPECT_NEAR(EvaluateCouple(BoxCouple(), At(2.99), behind).bumper, 6000, 1e-6);
  behind.v_WB.x = -0.25;
  EXPECT_NEAR(EvaluateCouple(BoxCouple(), At(2.99), behind).bumper, 1500, 1e-6);
  behind.v_WB.x = -5;
  EXPECT_EQ(EvaluateCouple(BoxCouple(), At(2.99), behind).bumper, 0);
}

TEST(Bumpers, BesideAndAbovePassEachOther) {
  EXPECT_EQ(EvaluateCouple(BoxCouple(), At(2.98, 1.9), At(0)).bumper, 0);
  EXPECT_GT(EvaluateCouple(BoxCouple(), At(2.98, 1.7), At(0)).bumper, 0);
  BodyState<double> high = At(2.98);
  high.p_WB.z += 0.5;
  EXPECT_EQ(EvaluateCouple(BoxCouple(), high, At(0)).bumper, 0);
}

TEST(Bumpers, ForcesAreEqualAndOppositeInAnyPose) {
  BodyState<double> ahead = At(2.9, 0.3, 0.2), behind = At(0, 0, -0.1);
  SetAngularVelocity(Box().bodies[0], {0.1, -0.2, 0.5}, ahead);
  behind.v_WB = {1, 0.2, 0};
  const CoupleForces c = EvaluateCouple(BoxCouple(), ahead, behind);
  ASSERT_GT(c.bumper, 0);
  ExpectNoResultant(c, ahead, behind);
}

TEST(Bumpers, MomentumIsKeptThroughAnImpact) {
  const VehicleModel box = Box();
  const Couple couple = BoxCouple();
  EngineState<double> a, b;
  a.bodies = {At(3.05, 0.2)};
  b.bodies = {At(0)};
  b.bodies[0].v_WB.x = 2;
  Workspace<double> work(box);
  double most = 0;
  for (int i = 0; i < 400; ++i) {
    const CoupleForces c = EvaluateCouple(couple, a.bodies[0], b.bodies[0]);
    most = std::max(most, c.bumper);
    work.R_WB[0] = RotationMatrix(a.bodies[0].q_WB);
    work.wrench[0] = c.on_ahead;
    IntegrateBodies(box, 0, 1e-3, work, a);
    work.R_WB[0] = RotationMatrix(b.bodies[0].q_WB);
    work.wrench[0] = c.on_behind;
    IntegrateBodies(box, 0, 1e-3, work, b);
  }
  EXPECT_GT(most, 1e4);
  EXPECT_NEAR(a.bodies[0].v_WB.x + b.bodies[0].v_WB.x, 2, 1e-12);
  EXPECT_GT(a.bodies[0].v_WB.x, 1.0);  // more than the half that a plastic impact gives
  EXPECT_LT(b.bodies[0].v_WB.x, 1.0);
  // Energy is lost, not made.
  EXPECT_LT(KineticEnergy(box, a) + KineticEnergy(box, b), 0.5 * 750 * 4);
}

TEST(Drawbar, TensionByHandAndNoResultant) {
  Couple couple = BoxCouple();
  couple.towed = true;
  couple.drawbar = {{-1.5, 0, -0.1}, {1.5, 0, -0.1}, 2.0, 5e5, 1e4};
  BodyState<double> ahead = At(5.01), behind = At(0);
  // 5.01 - 3 = 2.01 m long: 5e5 * 0.01 = 5,000 N; drawing apart at 0.1 m/s adds 1,000 N.
  EXPECT_NEAR(EvaluateCouple(couple, ahead, behind).drawbar, 5000, 1e-6);
  ahead.v_WB.x = 0.1;
  const CoupleForces c = EvaluateCouple(couple, ahead, behind);
  EXPECT_NEAR(c.drawbar, 6000, 1e-6);
  EXPECT_NEAR(c.on_behind.f_W.x, 6000, 1e-6);
  ExpectNoResultant(c, ahead, behind);
  ExpectNoResultant(EvaluateCouple(couple, At(4.9, 0.5, 0.3), behind), At(4.9, 0.5, 0.3), behind);
}

TEST(Drawbar, AngleIsThatOfTheBarAgainstTheTrailer) {
  Couple couple = BoxCouple();
  couple.towed = true;
  couple.drawbar = {{-1.5, 0, 0}, {1.5, 0, 0}, 2.0, 5e5, 1e4};
  // Hitch at (3.5, 1), pivot at (1.5, 0): atan(1 / 2).
  EXPECT_NEAR(DrawbarAngle(couple, At(5, 1), At(0)), std::atan(0.5), 1e-12);
  EXPECT_NEAR(DrawbarAngle(couple, At(5), At(0)), 0, 1e-12);
}

TEST(BumperGap, IsMeasuredAlongTheVehicleBehind) {
  EXPECT_NEAR(BumperGap(BoxCouple(), At(5), At(0)), 2.0, 1e-12);
  EXPECT_NEAR(BumperGap(BoxCouple(), At(2.9), At(0)), -0.1, 1e-12);
}

}  // namespace
}  // namespace dbd
