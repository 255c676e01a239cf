#include "joined_bodies.h"

#include <gtest/gtest.h>

#include "engine_model.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// Two links from different points of body 0 that meet at one point of body 1, a spring whose ball
/// is that point too, and a joint between other bodies.
VehicleModel LinksThatMeet() {
  VehicleModel vehicle;
  vehicle.bodies.resize(3);
  for (const double x : {1.0, 2.0}) {
    LinkModel link;
    link.body_a = 0, link.body_b = 1;
    link.p_A = {x, 0, 0}, link.p_B = {0, 0.5, 0};
    vehicle.links.push_back(link);
  }
  SpringModel spring;
  spring.body_a = 0, spring.body_b = 1;
  spring.p_A = {1.5, 0, 1}, spring.p_Q = {1, 0, 0}, spring.p_B = {0, 0.5, 0};
  vehicle.springs.push_back(spring);
  AxisJointModel joint;
  joint.body_a = 1, joint.body_b = 2;
  vehicle.joints.push_back(joint);
  return vehicle;
}

JoinedBodies Find(const VehicleModel& vehicle) {
  return FindJoinedBodies(vehicle, [](const auto& p, const auto& q) { return p == q; });
}

TEST(JoinedBodies, ElementsThatPullAtOnePointShareIt) {
  const JoinedBodies joined = Find(LinksThatMeet());
  ASSERT_EQ(joined.pairs.size(), 2u);
  ASSERT_EQ(joined.balls.size(), 1u);
  EXPECT_EQ(joined.balls[0].links.end - joined.balls[0].links.begin, 2);
  EXPECT_EQ(joined.balls[0].springs.end - joined.balls[0].springs.begin, 1);
}

TEST(JoinedBodies, ASpringAloneHasItsOwnBall) {
  VehicleModel vehicle = LinksThatMeet();
  vehicle.springs[0].p_B = {0, 0.25, 0};
  const JoinedBodies joined = Find(vehicle);
  ASSERT_EQ(joined.balls.size(), 2u);
  EXPECT_EQ(joined.balls[1].of_link, -1);
  EXPECT_EQ(joined.balls[1].of_spring, 0);
}

/// The same place in two bodies' frames is two points.
TEST(JoinedBodies, ABodysPointsAreItsOwn) {
  VehicleModel vehicle = LinksThatMeet();
  vehicle.links[0].body_b = 2;
  const JoinedBodies joined = Find(vehicle);
  EXPECT_EQ(joined.balls.size(), 2u);
  EXPECT_EQ(joined.pairs.size(), 3u);
}

TEST(JoinedBodies, EveryElementIsThereOnceBetweenItsBodies) {
  const VehicleModel& vehicle = Tm27();
  const JoinedBodies joined = Find(vehicle);
  std::vector<int> links(vehicle.links.size()), springs(vehicle.springs.size()),
      joints(vehicle.joints.size());
  for (const JoinedBodies::Pair& pair : joined.pairs) {
    const auto joins = [&](const auto& e) {
      return e.body_a == pair.body_a && e.body_b == pair.body_b;
    };
    for (int b = pair.balls.begin; b < pair.balls.end; ++b) {
      const JoinedBodies::Ball& ball = joined.balls[b];
      for (int i = ball.links.begin; i < ball.links.end; ++i) {
        EXPECT_TRUE(joins(vehicle.links[joined.links[i]]));
        ++links[joined.links[i]];
      }
      for (int i = ball.springs.begin; i < ball.springs.end; ++i) {
        EXPECT_TRUE(joins(vehicle.springs[joined.springs[i]]));
        ++springs[joined.springs[i]];
      }
    }
    for (int i = pair.joints.begin; i < pair.joints.end; ++i) {
      EXPECT_TRUE(joins(vehicle.joints[joined.joints[i]]));
      ++joints[joined.joints[i]];
    }
  }
  EXPECT_EQ(links, std::vector<int>(links.size(), 1));
  EXPECT_EQ(springs, std::vector<int>(springs.size(), 1));
  EXPECT_EQ(joints, std::vector<int>(joints.size(), 1));
  EXPECT_EQ(joined.pairs.size(), 4u);  // each wheel carrier and the chassis
}

}  // namespace
}  // namespace dbd
