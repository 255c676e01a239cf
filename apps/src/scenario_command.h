#pragma once

#include <string>

namespace dbd {

/// Flags of `dbd scenario`.
struct ScenarioArguments {
  std::string name;
  std::string vehicle = "tomcar-tm27";
  std::string compare;      ///< trajectory to compare with
  std::string out;          ///< trajectory to write
  std::string plots;        ///< directory for pictures
  std::string terrain;      ///< other ground: .csv grid or elevation raster
  double target_speed = 0;  ///< [m/s], 0 = the scenario's
  double bump_radius = 0;   ///< [m], 0 = the scenario's ground
  std::string bump_side = "both";
  double link_stiffness = 1;  ///< factor
  double step_factor = 1;
  std::string tire_scheme = "split";
  bool hold = false;  ///< test rig instead of engine and driver
  bool vertical_tire = false;
};

/// Drives one of the paper's scenarios, prints what it was like and, when asked, how well it agrees
/// with another program's trajectory. Throws InputError.
int RunScenario(const ScenarioArguments& arguments);

}  // namespace dbd
