#include <dbd/core/mobility.h>
#include <dbd/core/sinkage.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

// Static loads 2238.773 N (rear, driven) and 1439.977 N (front, rolling) in 7357.5 N of weight.
constexpr double kRear = 2238.773, kFront = 1439.977, kWeight = 750 * kGravity;

double FrontMobility(double cone_index) {
  const double deflection = kFront / 207021;
  return BrixiusMobilityNumber(cone_index, kFront, 0.2032, 0.635, deflection / 0.1651);
}
double RearMobility(double cone_index) {
  const double deflection = kRear / 235152;
  return BrixiusMobilityNumber(cone_index, kRear, 0.3048, 0.6604, deflection / 0.1778);
}

TEST(Mobility, NetTractionIsTheSumOverWheels) {
  for (const double cone_index : {150e3, 300e3, 600e3}) {
    const double pull = MaxNetTraction({}, RearMobility(cone_index)).ratio;
    const double drag = MotionResistanceRatio({}, FrontMobility(cone_index), 0);
    const double expected = (2 * kRear * pull - 2 * kFront * drag) / kWeight;
    EXPECT_NEAR(MaxNetTractionRatio(Tm27(), {cone_index, 0.88}), expected, 1e-5) << cone_index;
  }
}

TEST(Mobility, FirmSoilByHand) {
  // Both mobility numbers exceed the cap of 80: rear net 0.824191, front drag 1/80 + 0.04:
  // (4477.546 * 0.824191 - 2879.954 * 0.0525) / 7357.5 = 0.481027.
  EXPECT_NEAR(MaxNetTractionRatio(Tm27(), {1.8e6, 0.88}), 0.481027, 1e-5);
}

TEST(Mobility, FrictionLimitCutsTheGrossPart) {
  // Capacity at the cap 0.88 (1 - e^-8) = 0.879705; a limit of 0.3 takes 0.579705 off the rear.
  const double dry = MaxNetTractionRatio(Tm27(), {1.8e6, 0.88});
  const double ice = MaxNetTractionRatio(Tm27(), {1.8e6, 0.3});
  EXPECT_NEAR(dry - ice, 2 * kRear * 0.579705 / kWeight, 1e-5);
}

TEST(Mobility, SoftSoilStopsTheVehicle) {
  EXPECT_LT(MaxNetTractionRatio(Tm27(), {60e3, 0.88}), 0);
  double last = -1e9;
  for (double cone_index = 60e3; cone_index < 1.5e6; cone_index *= 1.1) {
    const double ratio = MaxNetTractionRatio(Tm27(), {cone_index, 0.88});
    EXPECT_GE(ratio, last);
    last = ratio;
  }
}

TEST(Mobility, AllWheelDriveClimbsMore) {
  VehicleModel vehicle = Tm27();
  vehicle.axles[1].driven = true;
  EXPECT_GT(MaxNetTractionRatio(vehicle, {300e3, 0.88}),
            MaxNetTractionRatio(Tm27(), {300e3, 0.88}));
}

TEST(Mobility, SinkageIsThatOfTheDeepestWheel) {
  const double cone_index = 200e3;
  const double rear = PoweredSinkage(cone_index, kRear, 0.3048, 0.6604, kRear / 235152 / 0.1778);
  const double front = PoweredSinkage(cone_index, kFront, 0.2032, 0.635, kFront / 207021 / 0.1651);
  EXPECT_NEAR(StaticSinkage(Tm27(), {cone_index, 0.88}), std::max(rear, front), 1e-6);
}

TEST(Mobility, StabilityAngleFromTrackAndHeight) {
  // atan(1.508 / (2 * 0.446019)) = atan(1.690512) = 59.394 deg.
  EXPECT_NEAR(ToDegrees(StaticStabilityAngle(Tm27())), 59.394, 0.001);
}

TEST(Mobility, AnAxleOnAPivotLeavesATriangle) {
  // The tractor tips over the line from the rear contact (0, 0.8, 0) to the front pivot (2.4, 0,
  // 0.6). Without the front axle its mass, 3050 kg at x = 1.131, z = 1 and 1200 kg of rear axle at
  // x = 0, z = 0.8386 (radius less deflection), has its centre at x = 0.81167, z = 0.9544; there
  // the line is 0.8 (1 - 0.33819) = 0.52945 to the side and 0.6 * 0.33819 = 0.20292 high.
  EXPECT_NEAR(ToDegrees(StaticStabilityAngle(*LoadVehicle("tractor"))),
              ToDegrees(std::atan(0.52945 / (0.9544 - 0.20292))), 0.1);
}

}  // namespace
}  // namespace dbd
