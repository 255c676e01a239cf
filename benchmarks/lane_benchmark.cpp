// Speed of packs of vehicles on one core: the paper's scenarios A-D driven whole by every lane of a
// pack, driver and powertrain included, on a raster of 0.02 m or 1 m cells. `real_time_factor`:
// simulated seconds of all lanes per CPU second. `DriveAlone` is the double-precision reference on
// the same raster: the ratio of the two is what lanes gain. `DriveWheelLanes` is one vehicle whose
// four wheels are the lanes.

#include <benchmark/benchmark.h>
#include <dbd/core/vehicle_database.h>

#include "scenario_drives.h"

namespace dbd {
namespace {

void SetRate(benchmark::State& state, double simulated) {
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

void Alone(benchmark::State& state, const std::string& name, int millimetres, bool wheel_lanes) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = ScenarioTerrain(name, millimetres);
  const Scenario scenario = MakeScenario(name);
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    simulated += DriveAlone(scenario, *vehicle, terrain, {.wheel_lanes = wheel_lanes});
  }
  SetRate(state, simulated);
}

void Lanes(benchmark::State& state, const std::string& name, int millimetres, LaneKind kind) {
  if (!LaneKindAvailable(kind)) {
    state.SkipWithError("this processor has no such lanes");
    return;
  }
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = ScenarioTerrain(name, millimetres);
  const Scenario scenario = MakeScenario(name);
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) simulated += DriveLanes(scenario, *vehicle, terrain, kind);
  SetRate(state, simulated);
}

void Register(const std::string& name, int millimetres) {
  const std::string where = name + "/" + std::to_string(millimetres) + "mm";
  benchmark::RegisterBenchmark(("DriveAlone/" + where).c_str(), Alone, name, millimetres, false)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("DriveWheelLanes/" + where).c_str(), Alone, name, millimetres, true)
      ->Unit(benchmark::kMillisecond);
  for (const LaneKind kind : {LaneKind::kFloat16, LaneKind::kFloat8, LaneKind::kFloat4Plain,
                              LaneKind::kDouble8, LaneKind::kDouble4}) {
    std::string lanes = LaneKindName(kind);
    std::erase_if(lanes, [](char c) { return c == ' ' || c == ','; });
    benchmark::RegisterBenchmark(("DriveLanes/" + where + "/" + lanes).c_str(), Lanes, name,
                                 millimetres, kind)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  for (const std::string name : {"A", "B", "C", "D"}) dbd::Register(name, 20);
  dbd::Register("C", 1000);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
