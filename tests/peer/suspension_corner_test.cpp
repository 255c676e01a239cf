#include "suspension_corner.h"

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

const Eigen::Vector3d kChassis(0.784, 0, 0.094);  // centre of mass in the reference frame

TEST(SuspensionCorner, FrontTurnsOnTheLowerArmsPivots) {
  const VehicleModel& vehicle = Tm27();
  const SuspensionCorner corner = FindCorner(vehicle, WheelOrder(vehicle)[0]);
  EXPECT_EQ(corner.upper_links.size(), 3u);  // two rods of the upper arm and the tie rod
  EXPECT_NEAR(std::abs(corner.axis.x()), 1, 1e-12);
  EXPECT_NEAR((corner.p_pivot + kChassis).y(), 0.223, 1e-12);
  EXPECT_NEAR((corner.p_pivot + kChassis).z(), -0.103, 1e-12);
  EXPECT_TRUE(corner.p_ball.isApprox(Eigen::Vector3d(0, -0.129, -0.065)));
}

TEST(SuspensionCorner, RearTurnsOnTheTrailingArmsPivot) {
  const VehicleModel& vehicle = Tm27();
  const SuspensionCorner corner = FindCorner(vehicle, WheelOrder(vehicle)[3]);
  EXPECT_TRUE(corner.upper_links.empty());
  EXPECT_NEAR(std::abs(corner.axis.y()), 1, 1e-12);
  EXPECT_NEAR((corner.p_pivot + kChassis).x(), 0.391, 1e-12);
  EXPECT_NEAR((corner.p_pivot + kChassis).z(), -0.071, 1e-12);
}

TEST(SuspensionCorner, RefusesASolidAxle) {
  const auto vehicle = LoadVehicle("utility-4x4");
  const int rear_left = WheelOrder(*vehicle)[2];
  EXPECT_EQ(InputErrorOf([&] { FindCorner(*vehicle, rear_left); }),
            vehicle->name + ": wheel \"" + vehicle->wheels[rear_left].name +
                "\" needs two wishbones with a tie rod, or a trailing arm with two pivots");
}

}  // namespace
}  // namespace dbd
