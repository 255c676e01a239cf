#pragma once

#include "plan_command.h"

namespace CLI {
class App;
}

namespace dbd {

/// Declares how candidates are found, driven and judged: all of `dbd plan` but terrain, vehicle,
/// ends and output. `plan` must outlive the parsing.
void AddPlanFlags(CLI::App* command, PlanArguments* plan);

}  // namespace dbd
