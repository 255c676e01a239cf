#pragma once

#include <dbd/core/vehicle_model.h>

namespace dbd {

// Variants of a vehicle for studies and comparisons. Each is trimmed again, so that the design pose
// stays the static equilibrium, and gets new steps by rule.

/// Stiff links and joints `factor` times as stiff; dampers by its square root, which keeps the
/// damping ratio of the link modes.
VehicleModel WithLinkStiffness(VehicleModel vehicle, double factor);

/// Vertical tire stiffness [N/m] of each axle, in the order of `vehicle.axles`.
VehicleModel WithTireStiffness(VehicleModel vehicle, const std::vector<double>& stiffness);

/// The tires of the reference trajectories: the paper's stiffness, rounded, 207 kN/m in front of the
/// vehicle's middle and 235 kN/m behind it.
VehicleModel WithReferenceTires(const VehicleModel& vehicle);

/// All steps `factor` times as long, still synchronised.
VehicleModel WithSteps(VehicleModel vehicle, double factor);

}  // namespace dbd
