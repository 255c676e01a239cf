#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/vehicle_model.h>

#include <vector>

#include "engine_state.h"

namespace dbd {

/// From the driver's command to the torques and steer angles of one vehicle's wheels.
class ControlUnit {
 public:
  /// `vehicle` must outlive it.
  explicit ControlUnit(const VehicleModel& vehicle);

  void Reset() { powertrain_ = {}; }

  /// `spins`: of all wheels [rad/s]. The torque is shared evenly among driven wheels: open
  /// differentials; what locked and limited-slip ones move across is found with the spins.
  void Update(const DriverCommand& command, const double* spins, double dt,
              WheelControls<double>& controls);

  /// Full brakes, no drive.
  WheelControls<double> HeldByBrakes() const;

  const PowertrainState& powertrain() const { return powertrain_; }

 private:
  const VehicleModel* vehicle_;
  std::vector<int> driven_;  // wheels
  PowertrainState powertrain_;
};

}  // namespace dbd
