#include "vehicle_command.h"

#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/core/vehicle_report.h>

#include <cstdio>

#include "cli.h"

namespace dbd {

int RunVehicleList() {
  for (const std::string& name : BuiltInVehicleNames()) {
    std::printf("%-20s %s\n", name.c_str(), LoadVehicle(name)->description.c_str());
  }
  return kExitOk;
}

int RunVehicleShow(const std::string& name) {
  std::fputs(BuiltInVehicleText(name).c_str(), stdout);
  return kExitOk;
}

int RunVehicleCheck(const std::string& name_or_file) {
  const auto vehicle = LoadVehicle(name_or_file);
  const VehicleReport report = CheckVehicle(*vehicle);
  std::printf("%s: %s\n", vehicle->name.c_str(), vehicle->description.c_str());
  std::printf("  mass                  %.1f kg\n", report.mass);
  std::printf("  mass centre height    %.3f m\n", report.mass_center_height);
  std::printf("  bounce frequency      %.2f Hz\n", report.bounce_frequency);
  for (std::size_t i = 0; i < report.wheel_loads.size(); ++i) {
    std::printf("  wheel load            %8.1f N  %s\n", report.wheel_loads[i],
                vehicle->wheels[i].name.c_str());
  }
  for (std::size_t i = 0; i < report.spring_forces.size(); ++i) {
    std::printf("  spring force          %8.1f N  %s\n", report.spring_forces[i],
                vehicle->springs[i].name.c_str());
  }
  return kExitOk;
}

}  // namespace dbd
