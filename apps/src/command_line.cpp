#include "command_line.h"

#include <CLI/CLI.hpp>

#include "batch_flags.h"
#include "common_flags.h"
#include "matrix_flags.h"
#include "plan_flags.h"
#include "scene_flags.h"
#include "terrain_flags.h"

#ifndef DBD_VERSION
#error "DBD_VERSION is set by the build"
#endif

namespace dbd {
namespace {

const char kHeadingNote[] =
    "Headings are compass degrees: 0 = north, clockwise (inside: yaw = pi/2 - heading). "
    "Map coordinates are those of the elevation file's own system; wgs84 means lon,lat.";

CLI::App* AddCommand(CLI::App* parent, const std::string& name, const std::string& description,
                     const std::string& footer) {
  CLI::App* command = parent->add_subcommand(name, description);
  command->footer(footer);
  command->fallthrough();
  return command;
}

void DeclarePlan(CLI::App* app, Commands* commands) {
  PlanArguments* plan = &commands->plan;
  CLI::App* command = AddCommand(
      app, "plan", "Find a route and prove it by driving it in simulation",
      std::string(kHeadingNote) +
          "\nExit codes: 0 route, 2 bad input, 3 no safe route, 4 stopped before any route.\n"
          "Example:\n  dbd plan --dem hills.tif --vehicle tomcar-tm27 --start 564050,146300 "
          "--goal 564950,146850 --out out/");
  AddTerrainFlags(command, &plan->terrain);
  AddVehicleFlag(command, &plan->vehicle);
  command->add_option("--start", plan->start, "Where from")
      ->required()
      ->option_text("X,Y[,HEADING_DEG]");
  command->add_option("--goal", plan->goal, "Where to")
      ->required()
      ->option_text("X,Y[,HEADING_DEG]");
  AddCoordinatesFlag(command, &plan->coordinates);
  AddPlanFlags(command, plan);
  AddOutFlag(command, &plan->out);
  AddJsonFlag(command, &plan->json, "plan.json instead of the summary");
  command->callback([commands, plan] { commands->run = [plan] { return RunPlan(*plan); }; });
}

void DeclareBatch(CLI::App* app, Commands* commands) {
  BatchArguments* batch = &commands->batch;
  CLI::App* command = AddCommand(
      app, "batch", "Answer a file of planning requests, one JSON object per line",
      std::string(kHeadingNote) +
          "\nA request has the keys dem, vehicle, start, goal and those of dbd plan's other flags "
          "(with _ for -), and perhaps an id and a priority:\n"
          "  {\"id\": \"a\", \"dem\": \"hills.tif\", \"vehicle\": \"tomcar-tm27\", \"start\": "
          "[564050, "
          "146300], \"goal\": [564950, 146850, 90], \"candidates\": 16}\n"
          "Exit codes: 0 all answered, 2 some requests are wrong (their results say why), 4 "
          "stopped.\n"
          "Example:\n  dbd batch requests.jsonl --out results.jsonl --resume\n"
          "  dbd batch requests.jsonl --shard 2/4 --out part2.jsonl\n"
          "  dbd batch --merge part*.jsonl --out results.jsonl");
  AddBatchFlags(command, batch);
  command->callback([commands, batch] { commands->run = [batch] { return RunBatch(*batch); }; });
}

void DeclareMatrix(CLI::App* app, Commands* commands) {
  MatrixArguments* matrix = &commands->matrix;
  CLI::App* command = AddCommand(
      app, "matrix", "Plan from each of many starts to each of many goals",
      std::string(kHeadingNote) +
          "\nWrites matrix.csv and matrix.json: status, time, energy, length and, with --draws, "
          "P(go) of every pair, for every vehicle and state of the soil. --deadline counts for "
          "each pair.\n"
          "Exit codes: 0 all answered, 2 some pairs are wrong (the table says why), 4 stopped.\n"
          "Example:\n  dbd matrix --dem hills.tif --vehicle tomcar-tm27 utility-4x4 --starts "
          "depots.geojson --goals huts.csv --routes --out out/\n"
          "  dbd matrix --dem hills.tif --materials soils.tif --soil dry=dry.json wet=wet.json "
          "--vehicle tomcar-tm27 --start 564050,146300 --goals huts.csv --out out/");
  AddMatrixFlags(command, matrix);
  command->callback(
      [commands, matrix] { commands->run = [matrix] { return RunMatrix(*matrix); }; });
}

void DeclareSimulate(CLI::App* app, Commands* commands) {
  SimulateArguments* simulate = &commands->simulate;
  CLI::App* command = AddCommand(
      app, "simulate", "Drive one given path, or straight ahead, and write the time series",
      std::string(kHeadingNote) +
          "\nExit codes: 0 drove to the end, 2 bad input, 3 stopped by the terrain.\n"
          "Example:\n  dbd simulate --dem hills.tif --vehicle tomcar-tm27 --path track.gpx "
          "--speed-kmh 20 --out drive/");
  AddTerrainFlags(command, &simulate->terrain);
  AddVehicleFlag(command, &simulate->vehicle);
  command->add_option("--path", simulate->path, "Line to follow: GPX, GeoJSON, KML or CSV")
      ->option_text("FILE");
  command
      ->add_option("--start", simulate->start,
                   "Default: the path's first point and direction; without a path the middle of "
                   "the map, heading east")
      ->option_text("X,Y[,HEADING_DEG]");
  AddCoordinatesFlag(command, &simulate->coordinates);
  command->add_option("--speed-kmh", simulate->speed_kmh, "Target speed, default 18")
      ->check(Within(0.1, 500.0))
      ->option_text("V");
  command
      ->add_option("--duration-s", simulate->duration,
                   "Longest drive; default 60, or what the path needs when that is more")
      ->check(Within(0.1, 1e6))
      ->option_text("T");
  command
      ->add_option("--multipass-exponent", simulate->multipass_exponent,
                   "Ruts deepen with each wheel n of a track as n^(1/A): 2-3 on loose, 4-5 on firm "
                   "soil; default: every wheel finds fresh soil")
      ->check(Within(1.0, 10.0))
      ->option_text("A");
  AddOutFlag(command, &simulate->out);
  AddJsonFlag(command, &simulate->json, "simulate.json instead of the summary");
  command->callback(
      [commands, simulate] { commands->run = [simulate] { return RunSimulate(*simulate); }; });
}

void AddScenarioVariants(CLI::App* command, ScenarioArguments* scenario) {
  command->add_option("--target-speed", scenario->target_speed, "Default: the scenario's [m/s]")
      ->check(Within(0.1, 100.0))
      ->option_text("V");
  command->add_option("--bump-radius", scenario->bump_radius, "A half cylinder at x = 15 m [m]")
      ->check(Within(0.01, 2.0))
      ->option_text("R");
  command->add_option("--bump-side", scenario->bump_side, "Under which track, default both")
      ->check(CLI::IsMember({"both", "left", "right"}))
      ->option_text("SIDE");
  command
      ->add_option("--terrain", scenario->terrain,
                   "Other ground: a CSV grid or an elevation raster, driven east from its origin")
      ->option_text("FILE");
  command->add_option("--link-stiffness", scenario->link_stiffness, "Factor on the stiff links")
      ->check(Within(0.01, 1e4))
      ->option_text("F");
  command->add_option("--step-factor", scenario->step_factor, "Factor on all time steps")
      ->check(Within(1e-3, 2.0))
      ->option_text("F");
  command->add_flag("--hold", scenario->hold,
                    "Forces of a test rig drive and hold the chassis, not engine and steering");
  CLI::Option* scheme =
      command
          ->add_option("--tire-scheme", scenario->tire_scheme,
                       "Held between tire updates: split (default) holds the contact's shape, hold "
                       "the force")
          ->check(CLI::IsMember({"split", "hold"}))
          ->option_text("NAME");
  command
      ->add_flag("--vertical-tire", scenario->vertical_tire,
                 "The reference trajectories' tire: vertical force only")
      ->excludes(scheme);
}

/// A scene was named: what belongs to scenarios A-D would have no effect.
void RefuseOptions(const CLI::App& scenario) {
  for (const CLI::Option* option : scenario.get_options()) {
    if (option->count() == 0) continue;
    throw CLI::ValidationError(option->get_name(), "has no meaning before a scene's name");
  }
}

void DeclareScenario(CLI::App* app, Commands* commands) {
  ScenarioArguments* scenario = &commands->scenario;
  CLI::App* command = AddCommand(
      app, "scenario",
      "Drive one of the paper's scenarios A-D, or compare it with another program; or a scene of "
      "many vehicles",
      "Example:\n  dbd scenario A --hold --vertical-tire --link-stiffness 10 --step-factor 0.5 "
      "--compare A.csv\n  dbd scenario convoy --vehicles 8\n  dbd scenario road-train");
  command->add_option("name", scenario->name, "A, B, C or D")->option_text("NAME");
  command
      ->add_option("--vehicle", scenario->vehicle,
                   "Built-in vehicle or JSON file, default tomcar-tm27")
      ->option_text("NAME|FILE");
  command->add_option("--compare", scenario->compare, "Trajectory to compare with")
      ->option_text("FILE.csv");
  command->add_option("--out", scenario->out, "Write the trajectory, same layout")
      ->option_text("FILE.csv");
  command
      ->add_option("--plots", scenario->plots,
                   "Directory for pictures of motion, forces and spectrum, with the reference's "
                   "curves when comparing; needs gnuplot")
      ->option_text("DIR");
  AddScenarioVariants(command, scenario);
  SceneArguments* scene = &commands->scene;
  DeclareScenes(command, scene,
                [commands, scene] { commands->run = [scene] { return RunScene(*scene); }; });
  command->require_subcommand(0, 1);
  command->callback([command, commands, scenario] {
    if (!command->get_subcommands().empty()) return RefuseOptions(*command);
    if (scenario->name.empty()) throw CLI::RequiredError("scenario: A, B, C, D or a scene");
    commands->run = [scenario] { return RunScenario(*scenario); };
  });
}

void DeclareTerrainGenerate(CLI::App* terrain, Commands* commands) {
  TerrainGenerateArguments* generate = &commands->terrain_generate;
  GeneratorOptions* options = &generate->options;
  CLI::App* command =
      AddCommand(terrain, "generate", "Write a synthetic landscape: hills, brook, soils and trees",
                 "Example:\n  dbd terrain generate --seed 7 --out land/");
  AddOutFlag(command, &generate->out);
  command->add_option("--seed", options->seed, "Which landscape, default 1")->option_text("N");
  command->add_option("--size", options->size, "Cells in x and in y, default 400")
      ->option_text("N");
  command->add_option("--cell-size-m", options->cell_size, "Default 1")->option_text("L");
  command->add_option("--relief-m", options->relief, "Highest minus lowest ground, default 30")
      ->option_text("H");
  command->add_option("--trees-per-hectare", options->tree_density, "Default 15")->option_text("N");
  command->add_flag("--walled-goal", options->walled_goal,
                    "Dig a closed trench that no vehicle crosses round the map's centre");
  command->callback([commands, generate] {
    commands->run = [generate] { return RunTerrainGenerate(*generate); };
  });
}

void DeclareTerrain(CLI::App* app, Commands* commands) {
  CLI::App* terrain = AddCommand(app, "terrain", "Generate or describe terrain",
                                 "Example:\n  dbd terrain info hills.tif");
  terrain->require_subcommand(1);
  DeclareTerrainGenerate(terrain, commands);
  TerrainInfoArguments* info = &commands->terrain_info;
  CLI::App* command = AddCommand(terrain, "info", "Say what terrain and path files hold",
                                 "Example:\n  dbd terrain info hills.tif track.gpx --json");
  command
      ->add_option("files", info->files,
                   "Rasters, OctoMaps, meshes (.ply, .obj), points (.xyz), paths, areas")
      ->required()
      ->option_text("FILE...");
  command->add_option("--preview", info->preview, "Draw the first file's ground")
      ->option_text("FILE.png");
  AddJsonFlag(command, &info->json, "the description as JSON");
  command->callback([commands, info] { commands->run = [info] { return RunTerrainInfo(*info); }; });
}

void DeclareVehicle(CLI::App* app, Commands* commands) {
  CLI::App* vehicle =
      AddCommand(app, "vehicle", "List, show or check vehicles", "Example:\n  dbd vehicle list");
  vehicle->require_subcommand(1);
  CLI::App* list =
      AddCommand(vehicle, "list", "Names of the built-in vehicles", "Example:\n  dbd vehicle list");
  list->callback([commands] { commands->run = RunVehicleList; });
  const auto declare = [&](const std::string& name, const std::string& description,
                           const std::string& argument, int (*run)(const std::string&)) {
    CLI::App* command =
        AddCommand(vehicle, name, description, "Example:\n  dbd vehicle " + name + " tomcar-tm27");
    command->add_option("vehicle", commands->vehicle, "Which one")
        ->required()
        ->option_text(argument);
    command->callback(
        [commands, run] { commands->run = [commands, run] { return run(commands->vehicle); }; });
  };
  declare("show", "Print a built-in vehicle's or trailer's file", "NAME", RunVehicleShow);
  declare("check", "Set a vehicle on level ground and report its statics", "NAME|FILE",
          RunVehicleCheck);
}

}  // namespace

void DeclareCommands(CLI::App* app, Commands* commands) {
  app->name("dbd");
  app->description("Plans off-road routes by driving every candidate in vehicle dynamics.");
  app->set_version_flag("--version", "dbd " DBD_VERSION);
  app->add_flag("-v,--verbose", commands->verbose, "Say more on standard error");
  app->add_flag("-q,--quiet", commands->quiet, "Say nothing but errors on standard error");
  app->require_subcommand(1);
  app->footer("Example:\n  dbd terrain generate --out land/\n  dbd plan --help");
  DeclarePlan(app, commands);
  DeclareBatch(app, commands);
  DeclareMatrix(app, commands);
  DeclareSimulate(app, commands);
  DeclareScenario(app, commands);
  DeclareTerrain(app, commands);
  DeclareVehicle(app, commands);
}

}  // namespace dbd
