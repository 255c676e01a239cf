#include "matrix_flags.h"

#include <CLI/CLI.hpp>

#include "common_flags.h"
#include "plan_flags.h"
#include "terrain_flags.h"

namespace dbd {
namespace {

/// `kind`: "start" or "goal".
void AddPlacesFlags(CLI::App* command, const std::string& kind, std::string* file,
                    std::vector<std::string>* typed) {
  command
      ->add_option("--" + kind + "s", *file,
                   "Points of GeoJSON, GPX, KML, GeoPackage or CSV (columns lon and lat, or x and "
                   "y), perhaps with the attributes name and heading_deg")
      ->option_text("FILE");
  command->add_option("--" + kind, *typed, "Further places, in the coordinates of --coords")
      ->option_text("X,Y[,HEADING_DEG]...");
}

}  // namespace

void AddMatrixFlags(CLI::App* command, MatrixArguments* matrix) {
  PlanArguments* plan = &matrix->plan;
  AddTerrainFlags(command, &plan->terrain);
  command
      ->add_option(
          "--soil", matrix->soils,
          "States of the soil, each dry, moist or wet as for --moisture, or a name and the "
          "material table that holds then, instead of --material-table")
      ->excludes("--moisture")
      ->option_text("dry|moist|wet|NAME=TABLE...");
  command
      ->add_option("--vehicle", matrix->vehicles,
                   "Built-in vehicles (dbd vehicle list) or JSON files")
      ->required()
      ->option_text("NAME|FILE...");
  AddPlacesFlags(command, "start", &matrix->starts_file, &matrix->starts);
  AddPlacesFlags(command, "goal", &matrix->goals_file, &matrix->goals);
  AddCoordinatesFlag(command, &plan->coordinates);
  AddPlanFlags(command, plan);
  AddOutFlag(command, &plan->out);
  command->add_flag("--routes", matrix->routes, "Write the routes too, to routes.geojson");
  AddJsonFlag(command, &plan->json, "matrix.json instead of the summary");
}

}  // namespace dbd
