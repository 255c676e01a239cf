#pragma once

#include <dbd/core/internal/json_object.h>
#include <dbd/core/vehicle_model.h>

namespace dbd {

/// Reads one entry of "axles" with its suspension, wheels and tires, and adds it to the vehicle.
/// Throws InputError.
void ReadAxle(const internal::JsonObject& object, VehicleModel& vehicle);

}  // namespace dbd
