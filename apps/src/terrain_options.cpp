#include "terrain_options.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>

#include "console.h"
#include "places.h"

namespace dbd {

namespace {

void CheckTogether(const TerrainArguments& arguments) {
  if (!arguments.materials.empty() && arguments.material_table.empty()) {
    throw InputError("--materials needs --material-table: what do its classes mean?");
  }
  if (arguments.materials.empty() && !arguments.material_table.empty()) {
    throw InputError("--material-table needs --materials: where do its classes lie?");
  }
  if (arguments.materials.empty() && !arguments.unknown_material.empty()) {
    throw InputError("--unknown-material needs --materials");
  }
  if (arguments.obstacles.empty() && !arguments.obstacles_origin.empty()) {
    throw InputError("--obstacles-origin needs --obstacles");
  }
}

MapPlacement ParsePlacement(const std::string& flag, const std::string& text) {
  MapPlacement placement;
  if (text.empty()) return placement;
  const TypedPlace typed = ParsePlace(flag, text);
  placement.origin = typed.xy;
  // A yaw, not a compass heading: counter-clockwise.
  placement.yaw = Degrees(typed.heading_deg.value_or(0));
  return placement;
}

}  // namespace

TerrainFiles MakeTerrainFiles(const TerrainArguments& arguments) {
  CheckTogether(arguments);
  TerrainFiles files;
  files.elevation = arguments.dem.front();
  files.more_elevation.assign(arguments.dem.begin() + 1, arguments.dem.end());
  files.elevation_band = arguments.band;
  files.crs = arguments.crs;
  files.unknown_ground =
      arguments.unknown_ground == "fill" ? UnknownGround::kFill : UnknownGround::kForbid;
  files.fill_distance = arguments.fill_distance_m;
  files.materials = arguments.materials;
  files.materials_band = arguments.materials_band;
  files.material_field = arguments.material_field;
  files.unknown_material = arguments.unknown_material;
  files.material_table = arguments.material_table;
  files.moisture = MoistureStateOf(arguments.moisture);
  files.obstacles = arguments.obstacles;
  files.elevation_placement = ParsePlacement("--dem-origin", arguments.dem_origin);
  files.memory_limit = 1e9 * arguments.memory_gb;
  files.surface_cell_size = arguments.surface_cell_m;
  files.rasterise_tin = arguments.rasterise;
  files.obstacles_placement = ParsePlacement("--obstacles-origin", arguments.obstacles_origin);
  files.unknown_space =
      arguments.unknown_space == "blocked" ? UnknownSpace::kBlocked : UnknownSpace::kFree;
  files.surface_model = arguments.surface_model;
  files.surface_threshold = arguments.surface_threshold_m;
  return files;
}

std::shared_ptr<const Terrain> LoadTerrain(const TerrainArguments& arguments,
                                           const PlacesToKeep& places) {
  TerrainFiles files = MakeTerrainFiles(arguments);
  files.places = places.map;
  files.wgs84_places = places.wgs84;
  ProgressLine progress;
  auto terrain = LoadTerrain(files, [&progress](const std::string& stage, int done, int total) {
    progress.Show(stage, done, total);
  });
  progress.Clear();
  for (const std::string& note : terrain->notes()) PrintNote(note);
  return terrain;
}

}  // namespace dbd
