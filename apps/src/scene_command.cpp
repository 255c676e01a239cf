#include "scene_command.h"

#include <dbd/core/scene_scenario.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/body_executor.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "cli.h"
#include "scenario_ground_file.h"
#include "scene_plots.h"
#include "text.h"

namespace dbd {
namespace {

constexpr double kConvoySpeed = 5, kTrainSpeed = 4;  // [m/s]

SceneScenario MakeSceneAsAsked(const SceneArguments& arguments) {
  SceneScenarioOptions options;
  options.target_speed = arguments.road_train ? kTrainSpeed : kConvoySpeed;
  if (arguments.target_speed > 0) options.target_speed = arguments.target_speed;
  options.gap.time_gap = arguments.time_gap;
  if (!arguments.terrain.empty()) options.ground = LoadScenarioGround(arguments.terrain);
  const std::string usual = arguments.road_train ? "tractor" : "tomcar-tm27";
  const auto vehicle = LoadVehicle(arguments.vehicle.empty() ? usual : arguments.vehicle);
  if (!arguments.road_train) return MakeConvoyScenario(vehicle, arguments.vehicles, options);
  return MakeRoadTrainScenario(vehicle, LoadTrailer(arguments.trailer), arguments.trailers,
                               options);
}

std::string TitleOf(const SceneScenario& scenario) {
  std::string title = "Scene " + scenario.name + " with ";
  const std::size_t count = scenario.vehicles.size();
  const std::string& first = scenario.vehicles.front().model->name;
  const std::string& last = scenario.vehicles.back().model->name;
  if (first == last) return title + std::to_string(count) + " x " + first;
  return title + first + " and " + std::to_string(count - 1) + " x " + last;
}

void PrintGaps(const SceneRecord& record) {
  double least = 1e9, most = 0;
  for (const SceneRow& row : record.rows) {
    if (row.vehicle == 0) continue;
    least = std::min(least, row.gap);
    most = std::max(most, row.gap);
  }
  std::printf("  gaps       %.2f to %.2f m between bumpers; pressed with up to %.0f N\n", least,
              most, record.largest_bumper_force);
}

void PrintSummary(const SceneScenario& scenario, const SceneRecord& record, double wall_seconds,
                  const BodyExecutor& executor) {
  const std::size_t count = scenario.vehicles.size();
  const SceneRow& begin = record.rows.front();
  const SceneRow& end = record.rows[record.rows.size() - count];
  std::printf("%s: %s\n", TitleOf(scenario).c_str(), scenario.description.c_str());
  std::printf("  drive      %.1f m in %.1f s, %s\n", (end.p_WB - begin.p_WB).head<2>().norm(),
              record.seconds, record.arrived ? "all stand at the end" : "not to the end");
  if (scenario.vehicles.back().drawbar) {
    std::printf("  drawbars   force up to %.0f N, stretched by up to %.1f mm\n",
                record.largest_drawbar_force, 1e3 * record.largest_drawbar_stretch);
  } else if (count > 1) {
    PrintGaps(record);
  }
  std::printf(
      "  speed      %.1f x real time with %d bodies, steps of %.3g ms; %d threads, which shared "
      "%.0f %% of the steps\n",
      record.seconds / wall_seconds, record.bodies, 1e3 * record.step, executor.worker_count(),
      100 * executor.parallel_share());
  std::printf("  state      %s\n", HashText(record.hash).c_str());
}

/// Where the pictures go and who draws them, made sure of before the drive.
struct PlotTarget {
  explicit PlotTarget(const std::string& directory)
      : gnuplot("--plots"), output(directory, "--plots", ScenePlotFiles()) {}
  Gnuplot gnuplot;
  OutputDirectory output;
};

}  // namespace

int RunScene(const SceneArguments& arguments) {
  const SceneScenario scenario = MakeSceneAsAsked(arguments);
  std::optional<PlotTarget> plots;
  if (!arguments.plots.empty()) plots.emplace(arguments.plots);
  BodyExecutor executor({.threads = arguments.threads});
  const auto start = std::chrono::steady_clock::now();
  const SceneRecord record = RecordScene(scenario, executor);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (plots) {
    WriteScenePlots(TitleOf(scenario), record.rows, plots->gnuplot, &plots->output);
  }
  if (!arguments.out.empty()) WriteSceneRows(arguments.out, record.rows);
  if (plots) plots->output.Commit();
  PrintSummary(scenario, record, wall.count(), executor);
  return record.arrived ? kExitOk : kExitNoSafeRoute;
}

}  // namespace dbd
