// How far the engine is from what the processor could do. A counting number type goes through the
// engine's own templates and tells what a step does; loops that keep one unit busy tell, in the
// same run, what the machine can do at most. The engine alone is timed, without driver and
// powertrain: vehicles side by side on scenario C, on a raster of 0.02 m cells.
//
// Kind/<lanes>:
//   real_time_factor            measured
//   flops_per_vehicle_second    counted: +, -, x, /, sqrt that one vehicle alone needs
//   bound_real_time_factor      of what a pack does at the measured peaks: the greatest of the
//   times
//                               for arithmetic (comparisons and selections too), for divisions and
//                               roots, and for loads
//   bound_with_fused            the same, had multiplications and additions been fused; the engine
//                               does not fuse them, so that all lane types give the same bits
//   share_of_bound              measured over bound
//   divide_share_of_bound, load_share_of_bound: of the other limits' time, where not the greatest
//   useful_share                of a pack's operations, those that one vehicle alone needs
// Peak/<lanes>: the machine, per second; Stage/<lanes>/<stage>: the same by part of the step.

#include <benchmark/benchmark.h>
#include <dbd/core/vehicle_database.h>

#include <algorithm>
#include <map>
#include <vector>

#include "initial_state.h"
#include "roofline/count_stages.h"
#include "roofline/lane_measurement.h"
#include "roofline/stages.h"
#include "scenario_drives.h"

namespace dbd {
namespace {

struct Kind {
  RooflineKind kind;
  const char* name;
  LaneKind lanes;  // that the processor must have; any for scalars
};

constexpr Kind kKinds[] = {
    {RooflineKind::kScalar, "double", LaneKind::kFloat4Plain},
    {RooflineKind::kFloat4, "floatx4", LaneKind::kFloat4Plain},
    {RooflineKind::kFloat8, "floatx8", LaneKind::kFloat8},
    {RooflineKind::kFloat16, "floatx16", LaneKind::kFloat16},
    {RooflineKind::kDouble8, "doublex8", LaneKind::kDouble8},
};

const VehicleModel& Vehicle() {
  static const auto vehicle = LoadVehicle("tomcar-tm27");
  return *vehicle;
}

LaneMeasurement Measure(RooflineKind kind) {
  const Terrain& terrain = ScenarioTerrain("C", 20);
  static const auto start = InitialState<double>(Vehicle(), terrain, Eigen::Vector2d::Zero(), 0);
  return MeasureLanes(kind, Vehicle(), terrain, start);
}

const StageCounts& Counts(int lanes) {
  static std::map<int, StageCounts> known;
  const auto found = known.find(lanes);
  if (found != known.end()) return found->second;
  return known.emplace(lanes, CountStages(Vehicle(), ScenarioTerrain("C", 20), lanes))
      .first->second;
}

OperationCounts Sum(const StageCounts& stages) {
  OperationCounts sum;
  for (const OperationCounts& stage : stages) sum += stage;
  return sum;
}

/// Least seconds per vehicle and step that each kind of unit needs.
struct Bounds {
  double arithmetic = 0, fused = 0, divide = 0, load = 0;
  double Greatest() const { return std::max({arithmetic, divide, load}); }
  double GreatestFused() const { return std::max({fused, divide, load}); }
};

Bounds BoundsOf(const OperationCounts& counts, const LaneMeasurement& measured) {
  using enum Operation;
  const MachinePeaks& peaks = measured.peaks;
  const double simple = SimpleOperations(counts);
  Bounds bounds;
  bounds.arithmetic = simple / peaks.simple;
  if (peaks.fused > 0) {
    bounds.fused = (simple - 2 * counts[kFused]) / peaks.simple + counts[kFused] / peaks.fused;
  }
  bounds.divide = counts[kDivide] / peaks.divide + counts[kSquareRoot] / peaks.square_root;
  // A pack's numbers and constants are one instruction each, places in the terrain one per lane.
  bounds.load = ((counts[kLoad] + counts[kConstant]) / measured.lanes + counts[kHeightRead] +
                 counts[kBoundRead]) /
                peaks.loads;
  return bounds;
}

bool Missing(const Kind& kind, benchmark::State& state) {
  if (LaneKindAvailable(kind.lanes)) return false;
  state.SkipWithError("this processor has no such lanes");
  return true;
}

/// Calls `set(measurement)` with the one of them that is the median of all, in units of what the
/// machine could do at the time.
template <class Set>
void Run(benchmark::State& state, const Kind& kind, const Set& set) {
  if (Missing(kind, state)) return;
  std::vector<LaneMeasurement> all;
  for ([[maybe_unused]] auto _ : state) all.push_back(Measure(kind.kind));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(), [](const auto& a, const auto& b) {
    return a.step_seconds * a.peaks.simple < b.step_seconds * b.peaks.simple;
  });
  set(*middle);
}

/// Zero is left out: the spread of zeros is not a number.
void SetCounter(benchmark::State& state, const char* name, double value) {
  if (value != 0) state.counters[name] = value;
}

void Whole(benchmark::State& state, const Kind& kind) {
  Run(state, kind, [&](const LaneMeasurement& measured) {
    const OperationCounts needed = Sum(Counts(1)), done = Sum(Counts(measured.lanes));
    const double step = Vehicle().steps.construction;
    const Bounds bounds = BoundsOf(done, measured);
    SetCounter(state, "real_time_factor", step / measured.step_seconds);
    SetCounter(state, "flops_per_vehicle_second", Flops(needed) / step);
    SetCounter(state, "bound_real_time_factor", step / bounds.Greatest());
    if (bounds.fused > 0) SetCounter(state, "bound_with_fused", step / bounds.GreatestFused());
    SetCounter(state, "share_of_bound", bounds.Greatest() / measured.step_seconds);
    SetCounter(state, "divide_share_of_bound", bounds.divide / bounds.Greatest());
    SetCounter(state, "load_share_of_bound", bounds.load / bounds.Greatest());
    SetCounter(state, "useful_share", SimpleOperations(needed) / SimpleOperations(done));
  });
}

void Peak(benchmark::State& state, const Kind& kind) {
  Run(state, kind, [&](const LaneMeasurement& measured) {
    const MachinePeaks& peaks = measured.peaks;
    SetCounter(state, "add_or_multiply_per_s", peaks.simple);
    SetCounter(state, "multiply_add_per_s", peaks.fused);
    SetCounter(state, "divide_per_s", peaks.divide);
    SetCounter(state, "square_root_per_s", peaks.square_root);
    SetCounter(state, "L1_bytes_per_s", peaks.loads * measured.lanes * measured.lane_bytes);
    SetCounter(state, "memory_bytes_per_s", peaks.memory_bytes);
  });
}

void OneStage(benchmark::State& state, const Kind& kind, std::size_t stage) {
  Run(state, kind, [&](const LaneMeasurement& measured) {
    using enum Operation;
    const OperationCounts& done = Counts(measured.lanes)[stage];
    const double seconds = measured.stage_share[stage] * measured.step_seconds;
    SetCounter(state, "share_of_time", measured.stage_share[stage]);
    SetCounter(state, "share_of_bound", BoundsOf(done, measured).Greatest() / seconds);
    SetCounter(state, "flops_per_step", Flops(done));
    SetCounter(state, "other_operations", SimpleOperations(done) - done[kAdd] - done[kMultiply]);
    SetCounter(state, "divisions_and_roots", done[kDivide] + done[kSquareRoot]);
    SetCounter(state, "loads_and_stores", done[kLoad] + done[kStore]);
    SetCounter(state, "constants", done[kConstant]);
    SetCounter(state, "terrain_reads", done[kHeightRead] + done[kBoundRead] + done[kSoilRead]);
  });
}

template <class... Arguments>
void Add(const std::string& name, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), arguments...)->Unit(benchmark::kMillisecond);
}

const Kind& Widest() {
  return LaneKindAvailable(LaneKind::kFloat16)  ? kKinds[3]
         : LaneKindAvailable(LaneKind::kFloat8) ? kKinds[2]
                                                : kKinds[1];
}

void Register() {
  for (const Kind& kind : kKinds) Add(std::string("Kind/") + kind.name, Whole, kind);
  for (const Kind& kind : kKinds) Add(std::string("Peak/") + kind.name, Peak, kind);
  for (std::size_t i = 0; i < kStages; ++i) {
    Add(std::string("Stage/") + Widest().name + "/" + kStageNames[i], OneStage, Widest(), i);
  }
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  dbd::Register();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
