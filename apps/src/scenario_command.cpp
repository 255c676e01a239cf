#include "scenario_command.h"

#include <dbd/core/error.h>
#include <dbd/core/scenario_record.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/core/vehicle_variant.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "cli.h"
#include "scenario_ground_file.h"
#include "scenario_plots.h"

namespace dbd {
namespace {

constexpr double kBumpX = 15.0;  // [m]

TrackSide SideOf(const std::string& name) {
  if (name == "left") return TrackSide::kLeft;
  if (name == "right") return TrackSide::kRight;
  return TrackSide::kBoth;
}

Scenario MakeScenarioAsAsked(const ScenarioArguments& arguments) {
  Scenario scenario = MakeScenario(arguments.name);
  if (arguments.target_speed > 0) scenario.target_speed = arguments.target_speed;
  if (arguments.bump_radius > 0 || arguments.bump_side != "both") {
    const double radius = arguments.bump_radius > 0 ? arguments.bump_radius : 0.1;
    scenario.ground = MakeBumpGround(kBumpX, radius, SideOf(arguments.bump_side));
  }
  if (!arguments.terrain.empty()) scenario.ground = LoadScenarioGround(arguments.terrain);
  return scenario;
}

VehicleModel MakeVehicleAsAsked(const ScenarioArguments& arguments) {
  VehicleModel vehicle = *LoadVehicle(arguments.vehicle);
  if (arguments.vertical_tire && arguments.vehicle == "tomcar-tm27") {
    vehicle = WithReferenceTires(vehicle);
  }
  if (arguments.link_stiffness != 1) {
    vehicle = WithLinkStiffness(vehicle, arguments.link_stiffness);
  }
  return arguments.step_factor == 1 ? vehicle : WithSteps(vehicle, arguments.step_factor);
}

SimulationOptions MakeOptions(const ScenarioArguments& arguments, const Scenario& scenario) {
  SimulationOptions options;
  if (arguments.vertical_tire) options.tire = TireKind::kVerticalDisc;
  if (arguments.tire_scheme == "hold") options.tire_scheme = TireScheme::kHold;
  if (arguments.hold) {
    options.guide =
        GuideForces{.target_speed = scenario.target_speed, .standing_time = scenario.standing_time};
  }
  return options;
}

/// Largest pitch and roll, range of the chassis height, largest forces.
void PrintSummary(const Scenario& scenario, const VehicleModel& vehicle,
                  const std::vector<TrajectoryRow>& rows, double cpu_seconds) {
  double pitch = 0, roll = 0, tire = 0, spring = 0;
  for (const TrajectoryRow& row : rows) {
    pitch = std::max(pitch, std::abs(row.pitch));
    roll = std::max(roll, std::abs(row.roll));
    for (std::size_t i = 0; i < 4; ++i) {
      tire = std::max(tire, row.tire_force[i]);
      spring = std::max(spring, row.spring_force[i]);
    }
  }
  const auto [low, high] = std::minmax_element(
      rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.z_cg < b.z_cg; });
  std::printf("Scenario %s with %s: %s\n", scenario.name.c_str(), vehicle.name.c_str(),
              scenario.description.c_str());
  std::printf("  drive      %.1f m in %.1f s, %.2f m/s at the end\n",
              rows.back().x_cg - rows.front().x_cg, rows.back().t, rows.back().vx);
  std::printf("  chassis    height range %.1f mm, pitch up to %.2f deg, roll up to %.2f deg\n",
              1e3 * (high->z_cg - low->z_cg), ToDegrees(pitch), ToDegrees(roll));
  std::printf("  forces     spring up to %.0f N, tire up to %.0f N\n", spring, tire);
  std::printf("  speed      %.0f x real time on one core, steps of %.3g ms; the paper %.1f x\n",
              rows.back().t / cpu_seconds, 1e3 * vehicle.steps.construction,
              scenario.duration / scenario.paper_time);
}

void PrintAgreement(const std::string& file, const std::vector<SignalAgreement>& agreement) {
  std::printf("Agreement with %s, from t = 2 s, value at rest taken off\n", file.c_str());
  std::printf(
      "  signal      R2    rms %% of range    peak error %%    with the value at rest %%\n");
  for (const SignalAgreement& signal : agreement) {
    std::printf("  %-6s  %7.4f    %8.2f         %8.2f        %8.2f\n", signal.name.c_str(),
                signal.r_squared, 100 * signal.rms, 100 * signal.peak_error,
                100 * signal.peak_value_error);
  }
}

/// A link that joins the front left wheel to the chassis, -1 when there is none.
int FrontLink(const VehicleModel& vehicle) {
  const auto front = std::max_element(vehicle.axles.begin(), vehicle.axles.end(),
                                      [](const auto& a, const auto& b) { return a.x < b.x; });
  const int carrier = vehicle.wheels[static_cast<std::size_t>(front->left)].body;
  const auto link =
      std::find_if(vehicle.links.begin(), vehicle.links.end(),
                   [carrier](const LinkModel& l) { return l.body_a == 0 && l.body_b == carrier; });
  return link == vehicle.links.end() ? -1 : static_cast<int>(link - vehicle.links.begin());
}

/// Where the pictures go and who draws them, made sure of before the drive.
struct PlotTarget {
  explicit PlotTarget(const std::string& directory)
      : gnuplot("--plots"), output(directory, "--plots", ScenarioPlotFiles()) {}
  Gnuplot gnuplot;
  OutputDirectory output;
};

struct RecordedDrive {
  std::vector<TrajectoryRow> rows;
  std::vector<double> link_force;
  double cpu_seconds = 0;
};

RecordedDrive Record(const Scenario& scenario, const VehicleModel& vehicle,
                     const SimulationOptions& options, int link) {
  RecordedDrive drive;
  const std::clock_t begin = std::clock();
  drive.rows = RecordScenario(scenario, vehicle, options, [&](const Simulation& simulation) {
    if (link >= 0) drive.link_force.push_back(simulation.LinkForce(link));
  });
  drive.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return drive;
}

void DrawPlots(const Scenario& scenario, const VehicleModel& vehicle, const RecordedDrive& drive,
               const std::vector<TrajectoryRow>& reference, PlotTarget* target) {
  ScenarioPlots plots{"Scenario " + scenario.name + ", " + vehicle.name, drive.rows,
                      drive.link_force, "", reference};
  if (const int link = FrontLink(vehicle); link >= 0) {
    plots.link_name = vehicle.links[static_cast<std::size_t>(link)].name;
    std::replace(plots.link_name.begin(), plots.link_name.end(), '_', ' ');
  }
  WriteScenarioPlots(plots, target->gnuplot, &target->output);
}

}  // namespace

int RunScenario(const ScenarioArguments& arguments) {
  const Scenario scenario = MakeScenarioAsAsked(arguments);
  const VehicleModel vehicle = MakeVehicleAsAsked(arguments);
  const std::vector<TrajectoryRow> reference =
      arguments.compare.empty() ? std::vector<TrajectoryRow>() : ReadTrajectory(arguments.compare);
  std::optional<PlotTarget> plots;
  if (!arguments.plots.empty()) plots.emplace(arguments.plots);
  const RecordedDrive drive =
      Record(scenario, vehicle, MakeOptions(arguments, scenario), FrontLink(vehicle));
  const std::vector<TrajectoryRow>& rows = drive.rows;
  if (plots) DrawPlots(scenario, vehicle, drive, reference, &*plots);
  if (!arguments.out.empty()) WriteTrajectory(arguments.out, rows);
  if (plots) plots->output.Commit();
  PrintSummary(scenario, vehicle, rows, drive.cpu_seconds);
  if (!reference.empty()) {
    PrintAgreement(arguments.compare, CompareTrajectories(rows, reference));
  }
  return rows.back().t + 0.01 < scenario.duration ? kExitNoSafeRoute : kExitOk;
}

}  // namespace dbd
