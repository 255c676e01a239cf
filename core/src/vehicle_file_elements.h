#pragma once

#include <dbd/core/internal/json_object.h>
#include <dbd/core/vehicle_model.h>

namespace dbd {

/// Reads "connections", "contacts", "frictions" and "loads" of a vehicle file, all optional. They
/// name bodies ("chassis", "rear axle", "front left carrier"); points are in the reference frame.
/// Throws InputError.
void ReadElements(const internal::JsonObject& root, VehicleModel& vehicle);

}  // namespace dbd
