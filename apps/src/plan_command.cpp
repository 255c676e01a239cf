#include "plan_command.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/plan_route.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli.h"
#include "console.h"
#include "interrupt.h"
#include "output_directory.h"
#include "plan_files.h"
#include "plan_request.h"
#include "summary.h"

namespace dbd {
namespace {

Plan PlanWithProgress(const std::shared_ptr<const Terrain>& terrain,
                      const std::shared_ptr<const VehicleModel>& vehicle,
                      const PlanRequest& request, const PlanOptions& options,
                      const std::stop_token& stop) {
  ProgressLine progress;
  return PlanRoute(
      terrain, vehicle, request, options,
      [&progress](const std::string& stage, int done, int total) {
        progress.Show(stage, done, total);
      },
      stop);
}

/// What loading has left of the deadline [s].
double TimeLeft(std::chrono::steady_clock::time_point begin, double deadline) {
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - begin;
  return std::max(0.0, deadline - used.count());
}

}  // namespace

PlanOptions MakePlanOptions(const PlanArguments& arguments) {
  PlanOptions options;
  options.sampling.candidates = arguments.candidates;
  options.sampling.reversing = arguments.reversing;
  options.uncertainty.draws = arguments.draws;
  options.uncertainty.min_success = arguments.min_success;
  options.uncertainty.spread = {arguments.soil_spread, arguments.elevation_error_m,
                                arguments.elevation_correlation_m};
  options.learning.rounds = arguments.rounds;
  options.seed = arguments.seed;
  options.max_speed = KilometersPerHour(arguments.max_speed_kmh);
  options.threads = arguments.threads;
  options.engine =
      arguments.engine == "reference" ? RolloutEngine::kReference : RolloutEngine::kLanes;
  if (arguments.deadline_s > 0) options.deadline = arguments.deadline_s;
  options.Validate();
  return options;
}

int RunPlan(const PlanArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  Interrupt interrupt;
  PlanOptions options = MakePlanOptions(arguments);
  const TypedPlace start = ParsePlace("--start", arguments.start);
  const TypedPlace goal = ParsePlace("--goal", arguments.goal);
  OutputDirectory output(arguments.out);
  const auto vehicle = LoadVehicle(arguments.vehicle);
  PlacesToKeep places;
  places.In(arguments.coordinates) = {start.xy, goal.xy};
  const auto terrain = LoadTerrain(arguments.terrain, places);
  const Coordinates coordinates = arguments.coordinates;
  const PlanRequest request =
      MakePlanRequest({"--start", start, coordinates}, {"--goal", goal, coordinates}, *terrain);
  if (arguments.deadline_s > 0) options.deadline = TimeLeft(begin, arguments.deadline_s);
  const Plan plan = PlanWithProgress(terrain, vehicle, request, options, interrupt.token());
  const bool stopped =
      plan.status == PlanStatus::kCancelled || plan.status == PlanStatus::kDeadline;
  if (stopped && !plan.chosen) {
    PrintError(plan.reason);
    return kExitStopped;
  }
  const PlanRecord record{
      arguments, *terrain, *vehicle, request, options, plan, FilesBehind(arguments)};
  WritePlanFiles(record, &output);
  std::fputs((arguments.json ? PlanJson(record) : PlanSummary(record, output)).c_str(), stdout);
  return plan.chosen ? kExitOk : kExitNoSafeRoute;
}

}  // namespace dbd
