#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/vehicle_model.h>

#include "engine_state.h"

namespace dbd {

// From the driver's command to the torques and steer angles of a vehicle's wheels.

using WheelSpins = std::array<double, kMaxWheels>;

WheelSpins SpinsOf(const EngineState<double>& state);

void SetSteeringAndBrakes(const VehicleModel& vehicle, const DriverCommand& command,
                          WheelControls<double>& controls);
/// The same where the vehicle's geometry is at hand.
void SetSteeringAndBrakes(const VehicleModel& vehicle, const AckermannGeometry& geometry,
                          const DriverCommand& command, WheelControls<double>& controls);

/// Whether steering and brakes in force need not be set anew.
inline bool SteersAndBrakesAlike(const DriverCommand& a, const DriverCommand& b) {
  return a.steer == b.steer && a.brake == b.brake;
}

/// Advances the powertrain by `dt`; returns the torque on each of `driven` wheels, which turn at
/// `spin` [rad/s] on average.
double DriveTorquePerWheel(const PowertrainModel& model, const DriverCommand& command, double spin,
                           int driven, double dt, PowertrainState& powertrain);

/// Advances the powertrain by `dt`. The torque is shared evenly among driven wheels: open
/// differentials; what locked and limited-slip ones move across is found with the spins.
void SetDriveTorques(const VehicleModel& vehicle, const DriverCommand& command,
                     const WheelSpins& spins, double dt, PowertrainState& powertrain,
                     WheelControls<double>& controls);

/// Both.
void SetControls(const VehicleModel& vehicle, const DriverCommand& command, const WheelSpins& spins,
                 double dt, PowertrainState& powertrain, WheelControls<double>& controls);

/// Full brakes, no drive.
WheelControls<double> HeldByBrakes(const VehicleModel& vehicle);

}  // namespace dbd
