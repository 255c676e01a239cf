#pragma once

#include <string>

namespace dbd {

// All return the exit code and throw InputError.

/// Prints the names of the built-in vehicles with their descriptions.
int RunVehicleList();

/// Prints a built-in vehicle's JSON file.
int RunVehicleShow(const std::string& name);

/// Prints what a vehicle does when it stands on level ground.
int RunVehicleCheck(const std::string& name_or_file);

}  // namespace dbd
