#pragma once

#include <dbd/core/error.h>
#include <dbd/core/vehicle_database.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace dbd {

/// The built-in TM27, read once.
inline const VehicleModel& Tm27() {
  static const auto vehicle = LoadVehicle("tomcar-tm27");
  return *vehicle;
}

/// The TM27's vehicle file, to be changed by a test.
inline nlohmann::json Tm27Json() {
  return nlohmann::json::parse(BuiltInVehicleText("tomcar-tm27"));
}

/// A vehicle's name as a part of a test's name.
inline std::string Underscored(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Message of the InputError that `call` throws; empty when it throws none.
template <class Call>
std::string InputErrorOf(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace dbd
