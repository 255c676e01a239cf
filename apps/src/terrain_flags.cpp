#include "terrain_flags.h"

#include <CLI/CLI.hpp>

#include "common_flags.h"

namespace dbd {
namespace {

void AddElevationFlags(CLI::App* command, TerrainArguments* terrain) {
  command
      ->add_option(
          "--dem", terrain->dem,
          "Elevation: any raster that GDAL opens (several are joined, later ones on top), a "
          "TIN (.ply, .obj), points (.xyz), or an OctoMap (.bt, .ot) alone")
      ->required()
      ->option_text("FILE...");
  command->add_option("--band", terrain->band, "Band of the elevation, when it has several")
      ->check(CLI::Range(1, 65535))
      ->option_text("N");
  command
      ->add_option("--crs", terrain->crs,
                   "Coordinate system of the elevation, instead of what its file states")
      ->option_text("EPSG:N|WKT|PROJ");
  command
      ->add_option("--unknown-ground", terrain->unknown_ground,
                   "Where the elevation has holes: never drive there, or interpolate; default "
                   "forbid")
      ->check(CLI::IsMember({"forbid", "fill"}))
      ->option_text("forbid|fill");
  command
      ->add_option("--fill-distance-m", terrain->fill_distance_m,
                   "How far from known ground holes are filled, default 50")
      ->check(Within(0.01, 1e5))
      ->option_text("L");
}

void AddMemoryFlag(CLI::App* command, TerrainArguments* terrain) {
  command
      ->add_option("--memory-gb", terrain->memory_gb,
                   "Of a raster that would need more than half of this, the part round start and "
                   "goal, or round the path, is loaded; default 4")
      ->check(Within(0.01, 1e4))
      ->option_text("GB");
}

void AddSurfaceFlags(CLI::App* command, TerrainArguments* terrain) {
  command
      ->add_option("--dem-origin", terrain->dem_origin,
                   "Map coordinates of x = y = 0 of a TIN, points or OctoMap given as elevation, "
                   "and its turn (counter-clockwise)")
      ->option_text("X,Y[,YAW_DEG]");
  command
      ->add_option("--surface-cell-m", terrain->surface_cell_m,
                   "Cells of the raster made from it, default by its density")
      ->check(Within(0.01, 1000.0))
      ->option_text("L");
  command->add_flag("--rasterise", terrain->rasterise,
                    "Drive on a raster of the TIN instead of its triangles");
}

void AddMaterialFlags(CLI::App* command, TerrainArguments* terrain) {
  command
      ->add_option("--materials", terrain->materials,
                   "Which soil lies where: class raster, or polygons of any OGR format")
      ->option_text("FILE");
  command->add_option("--materials-band", terrain->materials_band, "Its band, when it has several")
      ->check(CLI::Range(1, 65535))
      ->option_text("N");
  command
      ->add_option("--material-field", terrain->material_field,
                   "Polygons' attribute with class number or material name; default the one "
                   "called class, code, material or name")
      ->option_text("NAME");
  command
      ->add_option("--unknown-material", terrain->unknown_material,
                   "What to take where there is no class or one that the table lacks; default: "
                   "refuse such classes, drive nowhere without a class")
      ->option_text("NAME");
  command
      ->add_option("--material-table", terrain->material_table,
                   "What the classes mean: a built-in table or a JSON file")
      ->option_text("NAME|FILE");
  command
      ->add_option("--moisture", terrain->moisture,
                   "How wet the soils are; default: as the table states them, moist")
      ->check(CLI::IsMember({"dry", "moist", "wet"}))
      ->option_text("dry|moist|wet");
}

void AddObstacleFlags(CLI::App* command, TerrainArguments* terrain) {
  command->add_option("--obstacles", terrain->obstacles, "OctoMap, .bt or .ot")
      ->option_text("FILE");
  command
      ->add_option("--obstacles-origin", terrain->obstacles_origin,
                   "Map coordinates of the OctoMap's x = y = 0 and its turn (counter-clockwise), "
                   "when it has a frame of its own")
      ->option_text("X,Y[,YAW_DEG]");
  command
      ->add_option("--unknown-space", terrain->unknown_space,
                   "What an OctoMap has not seen is free, the default, or in the way")
      ->check(CLI::IsMember({"free", "blocked"}))
      ->option_text("free|blocked");
  command
      ->add_option("--surface-model", terrain->surface_model,
                   "Raster of heights with trees and buildings: what rises above the elevation is "
                   "an obstacle")
      ->option_text("FILE");
  command
      ->add_option("--surface-threshold-m", terrain->surface_threshold_m,
                   "How far it must rise to be one, default 0.5")
      ->check(Within(0.0, 100.0))
      ->option_text("H");
}

}  // namespace

void AddTerrainFlags(CLI::App* command, TerrainArguments* terrain) {
  AddElevationFlags(command, terrain);
  AddMemoryFlag(command, terrain);
  AddSurfaceFlags(command, terrain);
  AddMaterialFlags(command, terrain);
  AddObstacleFlags(command, terrain);
}

}  // namespace dbd
