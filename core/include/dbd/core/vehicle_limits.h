#pragma once

#include <string>

namespace dbd {

/// What a vehicle may be exposed to (paper section 5.1, safety parameters), shared by the cheap
/// trafficability layer and by the judge of full rollouts so that the two cannot disagree.
struct VehicleLimits {
  double max_roll = 0.52;       ///< of the chassis against level [rad]
  double max_pitch = 0.61;      ///< of the chassis against level [rad]
  double max_slope = 0.61;      ///< of the ground under the vehicle, in any direction [rad]
  double max_sinkage = 0.1;     ///< of any wheel [m]
  double min_clearance = 0.02;  ///< between belly and ground [m]
  double max_speed = 15.0;      ///< a driver's limit, below the powertrain's [m/s]
  double max_lateral_acceleration = 3.0;  ///< in curves [m/s^2]
  double max_load_transfer = 0.9;         ///< (left - right)/(left + right) load; 1 = a side lifts
  double max_absorbed_power = 6.0;        ///< vertical, mean over 10 s [W]: the usual ride limit
  double max_shock = 2.5 * 9.81;          ///< peak vertical acceleration below 30 Hz [m/s^2]
};

/// The vehicle's box in the chassis frame, as seen in its design pose. Lengths [m].
struct VehicleOutline {
  double front = 0;         ///< foremost point ahead of the centre of mass
  double rear = 0;          ///< rearmost point behind the centre of mass, positive
  double half_width = 0;    ///< over everything
  double height = 0;        ///< top above the ground
  double belly_height = 0;  ///< lowest rigid part between the axles above the ground
};

}  // namespace dbd
