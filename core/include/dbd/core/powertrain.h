#pragma once

#include <dbd/core/vehicle_model.h>

namespace dbd {

// Powertrain (paper section 4.6): torque curve, automatic gear choice by engine speed, clutch with
// exponential delay, transfer case and differentials.

struct PowertrainState {
  int gear = 0;               ///< index into gear_ratios, when not in reverse
  bool reverse = false;       ///< the reverse gear is engaged
  double time_in_gear = 1e3;  ///< since the last shift [s]
  double engine_speed = 0;    ///< [rad/s]
  double engine_torque = 0;   ///< delivered [N m]
};

/// Largest torque at an engine speed: the polynomial between idle and the rev limit, nothing above
/// it. Below idle the clutch slips and the engine stays at its least speed.
double FullThrottleTorque(const PowertrainModel& powertrain, double engine_speed);

/// Engages the reverse gear or the lowest forward gear, when it is not that way already. The clutch
/// opens as for any shift.
void SelectDirection(bool reverse, PowertrainState& state);

/// From the torque asked for to the torque on the sum of all driven wheels [N m]. `wheel_speed`:
/// mean of the driven wheels [rad/s]. In reverse the torque asked for turns the wheels backwards,
/// and both wheel speed and wheel torque are negative.
double UpdatePowertrain(const PowertrainModel& powertrain, double asked_torque, double wheel_speed,
                        double dt, PowertrainState& state);

/// Speed at the rev limit in the highest gear, or where the drag-free power ends [m/s].
double TopSpeed(const VehicleModel& vehicle);

/// Sum of wheel forces per engine torque in the lowest gear [1/m].
double TractionPerEngineTorque(const VehicleModel& vehicle);

/// Largest sum of wheel torques, lowest gear [N m].
double MaxWheelTorque(const PowertrainModel& powertrain);

}  // namespace dbd
