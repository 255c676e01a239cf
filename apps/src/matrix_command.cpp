#include "matrix_command.h"

#include <dbd/core/error.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/planning_service.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>

#include "batch_answer.h"
#include "batch_tally.h"
#include "cli.h"
#include "console.h"
#include "interrupt.h"
#include "matrix_table.h"
#include "output_directory.h"
#include "plan_request.h"
#include "summary.h"
#include "text.h"

namespace dbd {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;

/// A state of the soil: a name, and which table and moisture hold then.
struct SoilState {
  std::string name;
  TerrainArguments terrain;
};

SoilState ParseSoilState(const std::string& text, const TerrainArguments& terrain) {
  if (MoistureStateOf(text)) {
    SoilState state{text, terrain};
    state.terrain.moisture = text;
    return state;
  }
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
    throw InputError("--soil: '" + text + "' is neither dry, moist, wet nor NAME=TABLE");
  }
  if (terrain.materials.empty()) {
    throw InputError("--soil " + text + " needs --materials: where do its classes lie?");
  }
  if (!terrain.material_table.empty()) {
    throw InputError("--soil " + text + " excludes --material-table");
  }
  SoilState state{text.substr(0, equals), terrain};
  state.terrain.material_table = text.substr(equals + 1);
  return state;
}

std::vector<SoilState> SoilStates(const MatrixArguments& arguments) {
  const TerrainArguments& terrain = arguments.plan.terrain;
  if (arguments.soils.empty()) return {{"", terrain}};
  std::vector<SoilState> states;
  for (const std::string& text : arguments.soils) states.push_back(ParseSoilState(text, terrain));
  return states;
}

MatrixAxes MakeAxes(const MatrixArguments& arguments, const std::vector<SoilState>& soils) {
  MatrixAxes axes;
  axes.vehicles = arguments.vehicles;
  for (const SoilState& soil : soils) axes.soils.push_back(soil.name);
  RefuseTwice("--vehicle", axes.vehicles);
  RefuseTwice("--soil", axes.soils);
  const Coordinates coordinates = arguments.plan.coordinates;
  axes.starts = ReadMatrixPlaces("start", arguments.starts_file, arguments.starts, coordinates);
  axes.goals = ReadMatrixPlaces("goal", arguments.goals_file, arguments.goals, coordinates);
  if (axes.size() > kMostPairs) {
    throw InputError(
        Format("the matrix has %zu pairs, must have at most %zu", axes.size(), kMostPairs));
  }
  return axes;
}

using Terrains = std::vector<std::shared_ptr<const Terrain>>;

Terrains LoadTerrains(const std::vector<SoilState>& soils, const MatrixAxes& axes) {
  PlacesToKeep places;
  for (const auto* list : {&axes.starts, &axes.goals}) {
    for (const MatrixPlace& place : *list) places.In(place.coordinates).push_back(place.place.xy);
  }
  Terrains terrains;
  for (const SoilState& soil : soils) terrains.push_back(LoadTerrain(soil.terrain, places));
  if (!places.wgs84.empty()) RequireCoordinates(Coordinates::kWgs84, *terrains.front());
  return terrains;
}

/// All pairs of one matrix, answered by one service.
class Matrix {
 public:
  Matrix(const MatrixArguments& arguments, const MatrixAxes& axes, PlanOptions options,
         Terrains terrains)
      : axes_(axes),
        options_(std::move(options)),
        threads_(arguments.plan.threads),
        keep_traces_(arguments.routes),
        terrains_(std::move(terrains)),
        answers_(axes.size()) {
    for (const std::string& name : axes.vehicles) vehicles_.push_back(LoadVehicle(name));
  }

  /// Answers every pair, or as many as the stop allows.
  void Run(const std::stop_token& stop) {
    PlanningService service({.threads = threads_, .queue_limit = 64});
    std::size_t submitted = 0;
    for (std::size_t i = 0; i < axes_.size() && !stop.stop_requested(); ++i) {
      ++submitted;
      if (AnswerAtOnce(i)) continue;
      PlanJob job{.prepare = [this, i] { return Prepare(axes_.Pair(i)); },
                  .on_end = [this, i](const JobResult& result) { Answer(i, result); }};
      while (!stop.stop_requested() && !service.TrySubmit(std::move(job))) Rest();
    }
    while (!stop.stop_requested() && Ended() < submitted) Rest();
  }  // the service ends what still runs

  const Terrains& terrains() const { return terrains_; }
  const std::vector<MatrixAnswer>& answers() const { return answers_; }
  const BatchTally& tally() const { return tally_; }

 private:
  static void Rest() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

  std::size_t Ended() {
    const std::lock_guard lock(mutex_);
    return tally_.answered();
  }

  /// Where nothing is to be planned.
  bool AnswerAtOnce(std::size_t index) {
    const MatrixPair pair = axes_.Pair(index);
    const MatrixPlace &start = axes_.starts[pair.start], &goal = axes_.goals[pair.goal];
    if (start.coordinates != goal.coordinates || start.place.xy != goal.place.xy) return false;
    const std::lock_guard lock(mutex_);
    tally_.Add("same_place");
    answers_[index] = {"same_place", "start and goal are the same place", Rollout(), {}, {}};
    return true;
  }

  PlanInputs Prepare(const MatrixPair& pair) const {
    const auto& terrain = terrains_[pair.soil];
    const MatrixPlace &start = axes_.starts[pair.start], &goal = axes_.goals[pair.goal];
    return {terrain, vehicles_[pair.vehicle],
            MakePlanRequest({"start " + start.name, start.place, start.coordinates},
                            {"goal " + goal.name, goal.place, goal.coordinates}, *terrain),
            options_};
  }

  void Answer(std::size_t index, const JobResult& result) {
    if (result.state == JobState::kCancelled) return;
    MatrixAnswer answer = AnswerOf(result);
    const std::lock_guard lock(mutex_);
    answers_[index] = std::move(answer);
    tally_.Add(result);
    tally_.Show(axes_.size(), progress_);
  }

  MatrixAnswer AnswerOf(const JobResult& result) const {
    MatrixAnswer answer{StatusOf(result), ReasonOf(result), {}, {}, {}};
    if (result.state != JobState::kDone) return answer;
    const Plan& plan = result.plan;
    answer.digest = plan.digest;
    if (!plan.chosen) return answer;
    const auto chosen = static_cast<std::size_t>(*plan.chosen);
    answer.route = plan.rollouts[chosen];
    if (!keep_traces_) answer.route->trace = {};
    if (!plan.success.empty()) answer.success = plan.success[chosen];
    return answer;
  }

  const MatrixAxes& axes_;
  const PlanOptions options_;
  const int threads_;
  const bool keep_traces_;
  const Terrains terrains_;
  std::vector<std::shared_ptr<const VehicleModel>> vehicles_;
  std::mutex mutex_;
  std::vector<MatrixAnswer> answers_;
  BatchTally tally_{"pairs"};
  ProgressLine progress_;
};

void WriteMatrixFiles(const MatrixRecord& record, bool routes, OutputDirectory* output) {
  WriteTextFile(output->Stage("matrix.csv"), MatrixCsv(record));
  WriteTextFile(output->Stage("matrix.json"), MatrixJson(record));
  if (routes) WriteTextFile(output->Stage("routes.geojson"), MatrixRoutes(record));
  output->Commit();
}

int ExitCodeOf(const Matrix& matrix) {
  for (const MatrixAnswer& answer : matrix.answers()) {
    if (answer.status != "cancelled") continue;
    PrintError("stopped; pairs that are not answered are called cancelled");
    return kExitStopped;
  }
  return matrix.tally().errors() > 0 ? kExitBadInput : kExitOk;
}

}  // namespace

int RunMatrix(const MatrixArguments& arguments) {
  Interrupt interrupt;
  const PlanOptions options = MakePlanOptions(arguments.plan);
  const std::vector<SoilState> soils = SoilStates(arguments);
  const MatrixAxes axes = MakeAxes(arguments, soils);
  OutputDirectory output(arguments.plan.out, "--out",
                         {"matrix.csv", "matrix.json", "routes.geojson"});
  Matrix matrix(arguments, axes, options, LoadTerrains(soils, axes));
  const LocalFrame& frame = matrix.terrains().front()->frame();
  if (arguments.routes && !frame.has_crs()) {
    throw InputError("--routes: the elevation file has no coordinate system, as GeoJSON needs");
  }
  matrix.Run(interrupt.token());
  const MatrixRecord record{axes, matrix.answers(), arguments.plan, frame};
  WriteMatrixFiles(record, arguments.routes, &output);
  const std::string summary = matrix.tally().Summary(0) + FilesWritten(output) + "\n";
  std::fputs((arguments.plan.json ? MatrixJson(record) : summary).c_str(), stdout);
  return ExitCodeOf(matrix);
}

}  // namespace dbd
