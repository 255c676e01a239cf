#include "common_flags.h"

#include <CLI/CLI.hpp>

#include "text.h"

namespace dbd {

CLI::Validator Within(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0;
        const bool read = CLI::detail::lexical_cast(text, value);
        return read && value >= low && value <= high
                   ? std::string()
                   : Format("'%s' is not a number from %g to %g", text.c_str(), low, high);
      },
      Format("NUMBER in [%g, %g]", low, high));
}

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
