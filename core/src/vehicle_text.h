#pragma once

#include <string>

namespace dbd {

/// The JSON text that `LoadVehicle` reads under this name. Throws InputError.
std::string VehicleText(const std::string& name_or_file);

}  // namespace dbd
