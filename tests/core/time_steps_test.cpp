#include "time_steps.h"

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

// One link of 5e5 N/m from a heavy chassis to a carrier of 28.55 kg, 1 kg m2, along y.
VehicleModel OneLink(double arm) {
  VehicleModel v;
  v.bodies.push_back({"chassis", 600, Eigen::Vector3d(200, 500, 600), {0, 0, 0}});
  v.bodies.push_back({"carrier", 28.55, Eigen::Vector3d::Ones(), {0, 1, 0}});
  LinkModel link;
  link.body_b = 1;
  link.p_A = {0, 0, arm};
  link.p_B = {0, 0, arm};
  link.stiffness = 5e5;
  v.links.push_back(link);
  return v;
}

TEST(TimeSteps, CriticalStepOfTheLighterBody) {
  // sqrt(28.55 / 5e5) = 7.55645 ms; without a lever arm nothing turns.
  const CriticalStep critical = CriticalStepOf(OneLink(0), OneLink(0).links[0]);
  EXPECT_NEAR(critical.translational, 7.55645e-3, 5e-9);
  EXPECT_TRUE(std::isinf(critical.rotational));
}

TEST(TimeSteps, RotationalCriticalStep) {
  // sqrt(1 / (5e5 * 0.2^2)) = 7.07107 ms.
  const CriticalStep critical = CriticalStepOf(OneLink(0.2), OneLink(0.2).links[0]);
  EXPECT_NEAR(critical.rotational, 7.07107e-3, 5e-9);
}

TEST(TimeSteps, Tm27CriticalSteps) {
  double translational = 1, rotational = 1;
  for (const LinkModel& link : Tm27().links) {
    const CriticalStep c = CriticalStepOf(Tm27(), link);
    translational = std::min(translational, c.translational);
    rotational = std::min(rotational, c.rotational);
  }
  EXPECT_NEAR(translational, 7.55645e-3, 5e-9);
  EXPECT_NEAR(rotational, 6.18e-3, 5e-6);
}

TEST(TimeSteps, RuleGivesTwoAndFourMilliseconds) {
  // Construction 6.18 / 3 = 2.06 -> 2 ms; tire 11.74 / 3 = 3.91 -> nearest multiple 4 ms.
  const StepSizes steps = ChooseStepSizes(Tm27());
  EXPECT_DOUBLE_EQ(steps.construction, 2e-3);
  EXPECT_DOUBLE_EQ(steps.spring, 2e-3);
  EXPECT_DOUBLE_EQ(steps.tire, 4e-3);
  EXPECT_DOUBLE_EQ(steps.control, 4e-3);
}

TEST(TimeSteps, StifferLinksNeedSmallerSteps) {
  VehicleModel v = Tm27();
  for (LinkModel& link : v.links) link.stiffness *= 16;
  // A quarter of 2.06 ms, rounded down to half a millisecond.
  EXPECT_DOUBLE_EQ(ChooseStepSizes(v).construction, 0.5e-3);
}

TEST(TimeSteps, GroupsAreWholeMultiplesAndNeverSlowerThanAsked) {
  StepSizes steps{1.5e-3, 2e-3, 4e-3, 10e-3};
  SynchroniseSteps(steps);
  EXPECT_DOUBLE_EQ(steps.construction, 1.5e-3);
  EXPECT_DOUBLE_EQ(steps.spring, 1.5e-3);
  EXPECT_DOUBLE_EQ(steps.tire, 3e-3);
  EXPECT_DOUBLE_EQ(steps.control, 9e-3);
  StepSizes exact{2e-3, 2e-3, 4e-3, 4e-3};
  SynchroniseSteps(exact);
  EXPECT_DOUBLE_EQ(exact.tire, 4e-3);
}

}  // namespace
}  // namespace dbd
