#pragma once

#include <dbd/core/vehicle_report.h>

namespace dbd {

/// Modes of the settled vehicle on level ground with locked wheels, from the finite-difference
/// Jacobian of all body forces against positions and velocities. `fastest` receives the largest
/// |eigenvalue| [rad/s].
std::vector<VibrationMode> FindModes(const VehicleModel& vehicle, double* fastest);

}  // namespace dbd
