#pragma once

#include <string>

#include "places.h"

namespace CLI {
class App;
class Validator;
}

namespace dbd {

/// A number in [low, high]; CLI::Range would let a NaN pass.
CLI::Validator Within(double low, double high);

// Flags that several sub-commands share. What they fill must outlive the parsing.

void AddVehicleFlag(CLI::App* command, std::string* vehicle);
void AddCoordinatesFlag(CLI::App* command, Coordinates* coordinates);
void AddThreadsFlag(CLI::App* command, int* threads);
/// A directory.
void AddOutFlag(CLI::App* command, std::string* out);
/// `what`: is printed instead of which other text.
void AddJsonFlag(CLI::App* command, bool* json, const std::string& what);

}  // namespace dbd
