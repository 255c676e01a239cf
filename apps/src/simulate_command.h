#pragma once

#include <string>

#include "places.h"
#include "terrain_options.h"

namespace dbd {

/// What `dbd simulate` was asked, as typed.
struct SimulateArguments {
  TerrainArguments terrain;
  std::string vehicle;
  std::string path;
  std::string start;
  Coordinates coordinates = Coordinates::kMap;
  double speed_kmh = 18;
  double duration = 0;            ///< [s], 0 = not given
  double multipass_exponent = 0;  ///< 0 = no multipass
  std::string out;
  bool json = false;
};

/// Drives one path, writes all results or none, and prints the outcome. Returns the exit code.
/// Throws InputError.
int RunSimulate(const SimulateArguments& arguments);

}  // namespace dbd
