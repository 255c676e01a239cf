#pragma once

#include <dbd/core/vehicle_model.h>

#include <string>

namespace dbd {

/// Sets every wheel's static load and centre height from the whole vehicle's balance on level
/// ground. More than two axles are statically indeterminate: the loads nearest to equal are taken.
/// Throws InputError, beginning with `origin`, when a wheel would have to pull.
void TrimWheelLoads(const std::string& origin, VehicleModel& vehicle);

/// Sets the free lengths of springs (where they are 0) and links, and the rest angles of joints,
/// so that the design pose is the static equilibrium. Where a body is held by more elements than it
/// needs, the forces of least strain energy are taken.
void TrimFreeLengths(VehicleModel& vehicle);

}  // namespace dbd
