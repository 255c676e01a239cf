#include "common_flags.h"

#include <CLI/CLI.hpp>

namespace dbd {

void AddVehicleFlag(CLI::App* command, std::string* vehicle) {
  command->add_option("--vehicle", *vehicle, "Built-in vehicle (dbd vehicle list) or JSON file")
      ->required()
      ->option_text("NAME|FILE");
}

void AddCoordinatesFlag(CLI::App* command, Coordinates* coordinates) {
  command
      ->add_option_function<std::string>(
          "--coords",
          [coordinates](const std::string& name) {
            *coordinates = name == "wgs84" ? Coordinates::kWgs84 : Coordinates::kMap;
          },
          "How coordinates are meant, default map")
      ->check(CLI::IsMember({"map", "wgs84"}))
      ->option_text("map|wgs84");
}

void AddThreadsFlag(CLI::App* command, int* threads) {
  command->add_option("--threads", *threads, "0 = all processors, the default")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
}

void AddOutFlag(CLI::App* command, std::string* out) {
  command->add_option("--out", *out, "Directory for the results, created when missing")
      ->required()
      ->option_text("DIR");
}

void AddJsonFlag(CLI::App* command, bool* json, const std::string& what) {
  command->add_flag("--json", *json, "Print " + what + " on standard output");
}

}  // namespace dbd
