#pragma once

#include <dbd/core/vehicle_model.h>

#include <array>
#include <vector>

namespace dbd {

/// What an ideal, rigid suspension of one wheel is made of, read from the stiff links that stand
/// for it. Points of the chassis and of the carrier in their body frames.
struct SuspensionCorner {
  int carrier = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();    ///< of the pin on the chassis
  Eigen::Vector3d p_pivot = Eigen::Vector3d::Zero();  ///< a point of it, on the chassis
  Eigen::Vector3d p_ball = Eigen::Vector3d::Zero();   ///< lower ball, on the carrier
  std::vector<int> upper_links;  ///< rods of the upper arm and of the steering; none: the carrier
                                 ///< itself turns on the pin
};

/// Throws InputError when the wheel hangs neither on wishbones and a tie rod nor on a trailing arm.
SuspensionCorner FindCorner(const VehicleModel& vehicle, int wheel);

/// Between a link's ends in the design pose [m].
double DesignLength(const VehicleModel& vehicle, const LinkModel& link);

/// Wheels in the order of a trajectory: front left, front right, rear left, rear right.
std::array<int, 4> WheelOrder(const VehicleModel& vehicle);

}  // namespace dbd
