#include "vibration.h"

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(Vibration, StifferSpringsBounceFaster) {
  const auto slowest = [](double factor) {
    VehicleModel v = Tm27();
    for (SpringModel& spring : v.springs) spring.stiffness *= factor;
    double fastest = 0;
    return FindModes(v, &fastest).front().frequency;
  };
  EXPECT_GT(slowest(2), slowest(1) * 1.2);
}

TEST(Vibration, WithoutDampersModesAreUndamped) {
  VehicleModel v = Tm27();
  for (LinkModel& link : v.links) link.damping = 0;
  for (SpringModel& spring : v.springs) spring.damping = 0;
  for (AxisJointModel& joint : v.joints) joint.damping = 0;
  for (WheelModel& wheel : v.wheels) wheel.tire.damping = 0;
  double fastest = 0;
  for (const VibrationMode& mode : FindModes(v, &fastest)) {
    if (mode.shape == "chassis z" || mode.shape == "chassis pitch") {
      EXPECT_LT(std::abs(mode.damping), 0.02) << mode.shape;
    }
  }
}

TEST(Vibration, FastestModeBelongsToTheConstruction) {
  // The rear toe constraint: 51 Hz, |lambda| = 324 / s and more with its tires.
  double fastest = 0;
  FindModes(Tm27(), &fastest);
  EXPECT_GT(fastest, 250);
  EXPECT_LT(fastest, 2 / Tm27().steps.construction);
}

}  // namespace
}  // namespace dbd
