#pragma once

#include <functional>
#include <string>
#include <vector>

#include "batch_command.h"
#include "matrix_command.h"
#include "plan_command.h"
#include "scenario_command.h"
#include "scene_command.h"
#include "simulate_command.h"
#include "terrain_command.h"
#include "vehicle_command.h"

namespace CLI {
class App;
}

namespace dbd {

/// Where the flags of every sub-command end up, and what the chosen one does.
struct Commands {
  bool quiet = false;
  bool verbose = false;
  PlanArguments plan;
  BatchArguments batch;
  MatrixArguments matrix;
  SimulateArguments simulate;
  ScenarioArguments scenario;
  SceneArguments scene;
  TerrainGenerateArguments terrain_generate;
  TerrainInfoArguments terrain_info;
  std::string vehicle;
  std::function<int()> run;  ///< set while parsing, by the sub-command that was named
};

/// Declares all sub-commands. `commands` must outlive the parsing and is filled by it.
void DeclareCommands(CLI::App* app, Commands* commands);

}  // namespace dbd
