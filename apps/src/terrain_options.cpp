#include "terrain_options.h"

#include <dbd/core/error.h>

#include "places.h"

namespace dbd {

TerrainFiles MakeTerrainFiles(const TerrainArguments& arguments) {
  if (!arguments.materials.empty() && arguments.material_table.empty()) {
    throw InputError("--materials needs --material-table: what do its classes mean?");
  }
  if (arguments.materials.empty() && !arguments.material_table.empty()) {
    throw InputError("--material-table needs --materials: where do its classes lie?");
  }
  if (arguments.obstacles.empty() && !arguments.obstacles_origin.empty()) {
    throw InputError("--obstacles-origin needs --obstacles");
  }
  TerrainFiles files;
  files.elevation = arguments.dem;
  files.materials = arguments.materials;
  files.material_table = arguments.material_table;
  files.obstacles = arguments.obstacles;
  if (!arguments.obstacles_origin.empty()) {
    files.obstacles_origin = ParsePoint("--obstacles-origin", arguments.obstacles_origin);
    files.obstacles_in_map_coordinates = false;
  }
  return files;
}

std::shared_ptr<const Terrain> LoadTerrain(const TerrainArguments& arguments) {
  return LoadTerrain(MakeTerrainFiles(arguments));
}

}  // namespace dbd
