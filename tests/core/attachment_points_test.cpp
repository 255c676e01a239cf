#include "attachment_points.h"

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// Two links from different points of body 0 that meet at one point of body 1, and a spring whose
/// ball is that point too and whose pivot is where the first link begins.
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
  return vehicle;
}

TEST(AttachmentPoints, SharedPointsAreKeptOnce) {
  const AttachmentPoints attachments(LinksThatMeet());
  ASSERT_EQ(attachments.points().size(), 4u);  // 3 on body 0, 1 on body 1, for 7 ends
  EXPECT_EQ(attachments.links()[0].b, attachments.links()[1].b);
  EXPECT_EQ(attachments.springs()[0].ball, attachments.links()[0].b);
  EXPECT_EQ(attachments.springs()[0].pivot, attachments.links()[0].a);
  EXPECT_NE(attachments.links()[0].a, attachments.links()[1].a);
}

TEST(AttachmentPoints, PointsOfABodyLieTogether) {
  const AttachmentPoints attachments(LinksThatMeet());
  EXPECT_EQ(attachments.first(), (std::vector<std::size_t>{0, 3, 4, 4}));  // body 2 has none
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(attachments.points()[i].body, 0);
  EXPECT_EQ(attachments.points()[3].body, 1);
}

/// The same place in two bodies' frames is two points.
TEST(AttachmentPoints, ABodysPointsAreItsOwn) {
  VehicleModel vehicle = LinksThatMeet();
  vehicle.links[0].body_b = 2;
  const AttachmentPoints attachments(vehicle);
  EXPECT_NE(attachments.links()[0].b, attachments.links()[1].b);
}

TEST(AttachmentPoints, NeverMoreThanTheWorkspaceHolds) {
  const VehicleModel& vehicle = Tm27();
  const AttachmentPoints attachments(vehicle);
  EXPECT_LE(attachments.points().size(), AttachmentPoints::Most(vehicle));
  EXPECT_EQ(attachments.first().back(), attachments.points().size());
}

}  // namespace
}  // namespace dbd
