#include "rig_forces.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

TireModel Tire(double radius, double stiffness) {
  TireModel tire;
  tire.radius = radius;
  tire.stiffness = stiffness;
  tire.damping = 500;
  return tire;
}

// The same worked numbers as for the engine's own version of this tire.
TEST(DeepestPointTireForce, OnABump) {
  const auto ground = MakeBumpGround(15, 0.1);
  EXPECT_NEAR(
      DeepestPointTireForce(*ground, Tire(0.3175, 207000), {14.8, 0.754, 0.3105}, {5, 0, 0}),
      12955.177749, 1e-5);
  EXPECT_NEAR(
      DeepestPointTireForce(*ground, Tire(0.3302, 235000), {15.1, -0.754, 0.4}, {5, 0, -0.5}),
      3990.369684, 1e-5);
}

TEST(DeepestPointTireForce, OnWavesAndInTheAir) {
  const auto ground = MakeSineGround(5, 30, 0.1, 5);
  EXPECT_NEAR(DeepestPointTireForce(*ground, Tire(0.3175, 207000), {7.3, 0.754, 0.33}, {2, 0, 0.1}),
              2868.259127, 1e-5);
  EXPECT_EQ(DeepestPointTireForce(*ground, Tire(0.3175, 207000), {0, 0, 0.32}, {2, 0, -1}), 0);
}

}  // namespace
}  // namespace dbd
