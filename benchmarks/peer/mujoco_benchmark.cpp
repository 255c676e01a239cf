// dbd and MuJoCo side by side on one core: the paper's scenarios A-D driven whole by the same
// driver and powertrain at the same step. `real_time_factor`: simulated seconds of all vehicles per
// CPU second. What the vehicles have in common, and what not, stands in mujoco_vehicle.h; dbd
// drives on a raster of 0.02 m cells with its full tire.

#include <benchmark/benchmark.h>
#include <dbd/core/vehicle_database.h>

#include "mujoco_vehicle.h"
#include "scenario_drives.h"

namespace dbd {
namespace {

/// `drive` returns the simulated seconds.
template <class Drive>
void Run(benchmark::State& state, const Drive& drive) {
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) simulated += drive();
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

void Dbd(benchmark::State& state, const std::string& name) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = ScenarioTerrain(name, 20);
  Run(state, [&] { return DriveAlone(MakeScenario(name), *vehicle, terrain); });
}

void DbdLanes(benchmark::State& state, const std::string& name) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = ScenarioTerrain(name, 20);
  Run(state, [&] { return DriveLanes(MakeScenario(name), *vehicle, terrain, LaneKind::kFloat); });
}

void Mujoco(benchmark::State& state, const std::string& name, MujocoContact contact) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Scenario scenario = MakeScenario(name);
  MujocoVehicle peer(scenario, *vehicle, contact);
  Run(state, [&] {
    peer.Reset();
    while (peer.time() < scenario.duration) peer.Advance();
    return scenario.duration;
  });
}

void Register(const std::string& name) {
  const auto add = [](const std::string& title, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(title.c_str(), function, arguments...)
        ->Unit(benchmark::kMillisecond);
  };
  std::string lanes = LaneKindName(LaneKind::kFloat);
  std::erase(lanes, ' ');
  add(name + "/dbd/double", Dbd, name);
  add(name + "/dbd/" + lanes, DbdLanes, name);
  add(name + "/mujoco/tire-like_contact", Mujoco, name, MujocoContact::kTire);
  add(name + "/mujoco/rigid_contact", Mujoco, name, MujocoContact::kRigid);
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  for (const std::string name : {"A", "B", "C", "D"}) dbd::Register(name);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
