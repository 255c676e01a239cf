#include "scene_flags.h"

#include <CLI/CLI.hpp>

#include "common_flags.h"

namespace dbd {
namespace {

/// What both scenes have.
void AddCommonFlags(CLI::App* command, SceneArguments* scene) {
  command->add_option("--target-speed", scene->target_speed, "Default 5, of a road train 4 [m/s]")
      ->check(Within(0.1, 100.0))
      ->option_text("V");
  command
      ->add_option("--terrain", scene->terrain,
                   "Other ground: a CSV grid or an elevation raster, driven east from its origin")
      ->option_text("FILE");
  AddThreadsFlag(command, &scene->threads);
  command->add_option("--out", scene->out, "Write all vehicles' motion and forces every 0.1 s")
      ->option_text("FILE.csv");
  command
      ->add_option("--plots", scene->plots,
                   "Directory for pictures of the speeds and of gaps or drawbars; needs gnuplot")
      ->option_text("DIR");
}

CLI::App* AddScene(CLI::App* scenario, const std::string& name, const std::string& description,
                   const std::string& example) {
  CLI::App* command = scenario->add_subcommand(name, description);
  command->fallthrough(false);  // flags of scenarios A-D have no meaning here
  command->footer("Exit codes: 0 all came to the end, 2 bad input, 3 they did not.\nExample:\n  " +
                  example);
  return command;
}

}  // namespace

void DeclareScenes(CLI::App* scenario, SceneArguments* scene, const std::function<void()>& chosen) {
  CLI::App* convoy =
      AddScene(scenario, "convoy", "Drive vehicles in a column that keep their distance",
               "dbd scenario convoy --vehicles 8 --out convoy.csv");
  convoy
      ->add_option("--vehicle", scene->vehicle,
                   "Built-in vehicle or JSON file, default tomcar-tm27")
      ->option_text("NAME|FILE");
  convoy->add_option("--vehicles", scene->vehicles, "How many, default 8")
      ->check(CLI::Range(1, 2000))
      ->option_text("N");
  convoy->add_option("--time-gap", scene->time_gap, "Kept to the vehicle ahead, default 1.5 [s]")
      ->check(Within(0.01, 60.0))
      ->option_text("T");
  AddCommonFlags(convoy, scene);
  convoy->callback([scene, chosen] {
    scene->road_train = false;
    chosen();
  });
  CLI::App* train = AddScene(scenario, "road-train", "Drive a vehicle with trailers",
                             "dbd scenario road-train --trailers 3 --plots plots/");
  train->add_option("--vehicle", scene->vehicle, "What tows them, default tractor")
      ->option_text("NAME|FILE");
  train
      ->add_option("--trailer", scene->trailer,
                   "Built-in trailer or JSON file, default farm-trailer")
      ->option_text("NAME|FILE");
  train->add_option("--trailers", scene->trailers, "How many, default 2")
      ->check(CLI::Range(0, 100))
      ->option_text("N");
  AddCommonFlags(train, scene);
  train->callback([scene, chosen] {
    scene->road_train = true;
    chosen();
  });
}

}  // namespace dbd
