#pragma once

#include <string>
#include <vector>

#include "plan_command.h"

namespace dbd {

/// What `dbd matrix` was asked, as typed.
struct MatrixArguments {
  PlanArguments plan;  ///< but for the vehicle and the ends
  std::vector<std::string> vehicles;
  std::vector<std::string> soils;  ///< "NAME=TABLE" each; none: the plan's table
  std::string starts_file;
  std::string goals_file;
  std::vector<std::string> starts;
  std::vector<std::string> goals;
  bool routes = false;
};

/// Plans from every start to every goal and writes the table, also of what was done before a stop.
/// Returns the exit code: 0 when all pairs were answered, 2 when some were refused, 4 when stopped.
/// Throws InputError.
int RunMatrix(const MatrixArguments& arguments);

}  // namespace dbd
