#pragma once

#include <dbd/core/internal/json_object.h>
#include <dbd/core/vehicle_model.h>

namespace dbd {

/// Reads what vehicle and trailer files have in common, and the powertrain unless `towed`; trims
/// the vehicle. Keys that it does not know are left to the caller.
VehicleModel ReadVehicle(const internal::JsonObject& root, const std::string& origin, bool towed);

}  // namespace dbd
