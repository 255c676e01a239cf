#include "initial_state.h"

#include <dbd/core/scenario.h>
#include <dbd/core/units.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(InitialState, SteeringOriginIsTheMiddleOfTheFixedAxle) {
  // The rear axle lies 0.784 m behind the chassis' centre of mass and 0.094 m below it.
  EXPECT_LT((SteeringOrigin(Tm27()) - Eigen::Vector3d(-0.784, 0, -0.094)).norm(), 1e-12);
}

TEST(InitialState, DesignPoseOnLevelGround) {
  const auto ground = MakePlaneGround(0, 0);
  const auto state = InitialState<double>(Tm27(), *ground, {3, 4}, Degrees(90));
  // Facing north: the centre of mass lies 0.784 m north of the rear axle, 0.475 m up.
  const Eigen::Vector3d expected(3, 4.784, 0.475);
  EXPECT_LT((ToEigen(state.bodies[0].p_WB) - expected).norm(), 1e-12);
  EXPECT_EQ(state.bodies[0].v_WB.x, 0);
  EXPECT_EQ(state.step, 0);
}

TEST(InitialState, EveryWheelTouchesATiltedPlaneAsDesigned) {
  const auto ground = MakePlaneGround(0.2, -0.3);
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.2, 0.3, 1).normalized();
  const auto state = InitialState<double>(Tm27(), *ground, {3, 4}, 0.7);
  for (const WheelModel& wheel : Tm27().wheels) {
    const Eigen::Vector3d hub = ToEigen(state.bodies[static_cast<std::size_t>(wheel.body)].p_WB);
    const double depth = wheel.tire.radius - hub.dot(normal);
    EXPECT_NEAR(depth, wheel.static_load / wheel.tire.stiffness, 1e-9);
  }
}

TEST(InitialState, HeadingIsKeptUphill) {
  // The slope rises in the direction of the heading.
  const auto ground = MakePlaneGround(0.3 * std::cos(0.7), 0.3 * std::sin(0.7));
  const auto state = InitialState<double>(Tm27(), *ground, {0, 0}, 0.7);
  const Vec3<double> x = RotationMatrix(state.bodies[0].q_WB).x;
  EXPECT_NEAR(std::atan2(x.y, x.x), 0.7, 1e-12);
  EXPECT_NEAR(x.z, 0.3 / std::sqrt(1 + 0.3 * 0.3), 1e-12);
}

TEST(InitialState, HeadingIsKeptAcrossASlope) {
  const auto ground = MakePlaneGround(0.2, -0.3);
  const auto state = InitialState<double>(Tm27(), *ground, {0, 0}, 0.7);
  const Vec3<double> x = RotationMatrix(state.bodies[0].q_WB).x;
  EXPECT_NEAR(std::atan2(x.y, x.x), 0.7, 1e-12);
}

TEST(InitialState, DampingTakesAShareOfTheMotion) {
  const auto ground = MakePlaneGround(0, 0);
  auto state = InitialState<double>(Tm27(), *ground, {0, 0}, 0);
  state.bodies[0].v_WB = {1, 2, 3};
  DampMotion(0.75, state);
  EXPECT_EQ(ToEigen(state.bodies[0].v_WB), Eigen::Vector3d(0.75, 1.5, 2.25));
}

}  // namespace
}  // namespace dbd
