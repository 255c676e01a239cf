#pragma once

#include <dbd/core/vehicle_model.h>

#include <memory>
#include <string>
#include <vector>

namespace dbd {

/// Names of the vehicles that are built into the library.
std::vector<std::string> BuiltInVehicleNames();

/// The JSON text of a built-in vehicle. Throws InputError that lists the names.
std::string BuiltInVehicleText(const std::string& name);

/// A built-in vehicle by name, or a vehicle file by path (anything that contains '/' or ends in
/// ".json"). Throws InputError that names the file, the key, the value and the rule.
std::shared_ptr<const VehicleModel> LoadVehicle(const std::string& name_or_file);

/// The same from JSON text (schema dbd.vehicle/1); `origin` is what messages call it.
std::shared_ptr<const VehicleModel> ParseVehicle(const std::string& text,
                                                 const std::string& origin);

}  // namespace dbd
