#include "scenario_ground_file.h"

#include <dbd/core/scenario.h>
#include <dbd/terrain/terrain.h>

namespace dbd {

std::shared_ptr<const Ground> LoadScenarioGround(const std::string& file) {
  if (file.ends_with(".csv")) return ReadGridGround(file);
  TerrainFiles files;
  files.elevation = file;
  return LoadTerrain(files);
}

}  // namespace dbd
