#include "vertical_tire.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dbd {
namespace {

constexpr double kFront = 0.3175, kRear = 0.3302;  // radii [m]

// A half cylinder of 0.1 m at x = 15. The points are 0.015 R = 4.7625 mm apart; the deepest one
// lies 0.1524 m ahead, at x = 14.9524: ground sqrt(0.1^2 - 0.0476^2) = 0.087944, disc 0.3105 -
// sqrt(0.3175^2 - 0.1524^2) = 0.031967, so 0.055977 deep. At 5 m/s the disc runs into it with
// 5 * 0.1524 / 0.278533 = 2.735765 m/s: 207000 * 0.055977273 + 500 * 2.735765 = 12955.18 N.
TEST(VerticalTire, RunsIntoABump) {
  const auto ground = MakeBumpGround(15, 0.1);
  const DiscContact contact = FindDiscContact(*ground, kFront, 14.8, 0.754, 0.3105);
  EXPECT_NEAR(contact.deflection, 0.055977273, 1e-9);
  EXPECT_NEAR(contact.ahead, 0.1524, 1e-12);
  EXPECT_NEAR(DiscForce(contact, kFront, 207000, 500, 5, 0), 12955.177749, 1e-5);
}

// Behind the bump's top and falling: 0.018373 deep 0.074295 m behind the centre; the bump falls
// away at 5 * 0.074295 / 0.321733 = 1.1546 m/s, the wheel sinks at 0.5 m/s.
TEST(VerticalTire, RollsOffABump) {
  const auto ground = MakeBumpGround(15, 0.1);
  const DiscContact contact = FindDiscContact(*ground, kRear, 15.1, -0.754, 0.4);
  EXPECT_NEAR(contact.deflection, 0.018373074, 1e-9);
  EXPECT_NEAR(contact.ahead, -0.074295, 1e-12);
  EXPECT_NEAR(DiscForce(contact, kRear, 235000, 500, 5, -0.5), 3990.369684, 1e-5);
}

// On waves of 0.1 m amplitude and 5 m length from x = 5 on.
TEST(VerticalTire, OnWaves) {
  const auto ground = MakeSineGround(5, 30, 0.1, 5);
  const DiscContact contact = FindDiscContact(*ground, kFront, 7.3, 0.754, 0.33);
  EXPECT_NEAR(contact.deflection, 0.014681800, 1e-9);
  EXPECT_NEAR(contact.ahead, -0.0381, 1e-12);
  EXPECT_NEAR(DiscForce(contact, kFront, 207000, 500, 2, 0.1), 2868.259127, 1e-5);
}

TEST(VerticalTire, NeitherPullsNorPushesFromTheAir) {
  const auto ground = MakePlaneGround(0, 0);
  EXPECT_EQ(DiscForce(FindDiscContact(*ground, kFront, 0, 0, 0.32), kFront, 207000, 500, 2, 0), 0);
  // 1 mm deep, 207 N, but leaving at 0.5 m/s: the damper would pull with 250 N.
  const DiscContact contact = FindDiscContact(*ground, kFront, 0, 0, kFront - 1e-3);
  EXPECT_NEAR(DiscForce(contact, kFront, 207000, 500, 2, 0), 207, 1e-9);
  EXPECT_EQ(DiscForce(contact, kFront, 207000, 500, 2, 0.5), 0);
}

}  // namespace
}  // namespace dbd
