#include "vehicle_command.h"

#include <dbd/core/trailer.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/core/vehicle_report.h>

#include <algorithm>
#include <cmath>
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
  const std::vector<std::string> trailers = BuiltInTrailerNames();
  const bool is_trailer = std::find(trailers.begin(), trailers.end(), name) != trailers.end();
  std::fputs((is_trailer ? BuiltInTrailerText(name) : BuiltInVehicleText(name)).c_str(), stdout);
  return kExitOk;
}

namespace {

void PrintStatics(const VehicleModel& vehicle, const VehicleReport& report) {
  std::printf("%s: %s\n", vehicle.name.c_str(), vehicle.description.c_str());
  std::printf("  mass                    %.1f kg, centre %.3f m above ground\n", report.mass,
              report.mass_center_height);
  std::printf("  settles                 %+.2f mm from the design height, pitch %+.3f deg\n",
              1e3 * report.settled_height_error, ToDegrees(report.settled_pitch));
  for (std::size_t i = 0; i < report.wheel_loads.size(); ++i) {
    std::printf("  wheel %-16s  load %8.1f N, tire deflection %.1f mm\n",
                vehicle.wheels[i].name.c_str(), report.wheel_loads[i],
                1e3 * report.tire_deflections[i]);
  }
  for (std::size_t i = 0; i < report.spring_forces.size(); ++i) {
    std::printf("  %-22s  force %8.1f N\n", vehicle.springs[i].name.c_str(),
                report.spring_forces[i]);
  }
}

void PrintRanges(const VehicleModel& vehicle, const VehicleReport& report) {
  for (const RangeReport& range : report.ranges) {
    std::printf("  %-4s range (%.2f)       %.1f m/s, %.1f deg by torque%s\n", range.name.c_str(),
                range.ratio, range.top_speed, ToDegrees(range.power_grade),
                range.name == vehicle.powertrain.range ? ", in use" : "");
  }
}

void PrintPerformance(const VehicleModel& vehicle, const VehicleReport& report) {
  std::printf("  top speed by gearing    %.1f m/s (%.0f km/h)\n", report.top_speed,
              3.6 * report.top_speed);
  std::printf("  steepest grade          %.1f deg by traction on firm soil, %.1f deg by torque\n",
              ToDegrees(report.traction_grade), ToDegrees(report.power_grade));
  PrintRanges(vehicle, report);
  std::printf("  side slope              %.1f deg static stability\n",
              ToDegrees(report.stability_angle));
  std::printf("  turning radius          %.2f m\n", report.min_turning_radius);
}

/// Milliseconds in a column; a dash where the group has no such motion.
std::string Milliseconds(double step) {
  if (!std::isfinite(step)) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", 1e3 * step);
  return text;
}

void PrintCriticalGroups(const VehicleReport& report) {
  std::printf("  critical steps [ms]     %-30s count  translational  rotational\n", "elements");
  for (const CriticalGroup& group : report.critical_groups) {
    std::printf("                          %-30s %5d  %13s  %10s\n", group.name.c_str(),
                group.count, Milliseconds(group.translational).c_str(),
                Milliseconds(group.rotational).c_str());
  }
}

void PrintDynamics(const VehicleModel& vehicle, const VehicleReport& report) {
  PrintCriticalGroups(report);
  std::printf(
      "  least critical steps    %.2f ms translational, %.2f ms rotational, %.2f ms for the "
      "fastest mode\n",
      1e3 * report.critical_translational, 1e3 * report.critical_rotational,
      1e3 * report.fastest_mode_limit);
  std::printf("  steps in use            construction %.2f ms, springs %.2f ms, tires %.2f ms\n",
              1e3 * vehicle.steps.construction, 1e3 * vehicle.steps.spring,
              1e3 * vehicle.steps.tire);
  for (const VibrationMode& mode : report.modes) {
    std::printf("  mode %6.2f Hz           damping %.3f, %s\n", mode.frequency, mode.damping,
                mode.shape.c_str());
  }
}

}  // namespace

int RunVehicleCheck(const std::string& name_or_file) {
  const auto vehicle = LoadVehicle(name_or_file);
  const VehicleReport report = CheckVehicle(*vehicle);
  PrintStatics(*vehicle, report);
  PrintPerformance(*vehicle, report);
  PrintDynamics(*vehicle, report);
  return kExitOk;
}

}  // namespace dbd
