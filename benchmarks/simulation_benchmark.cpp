// Speed of one vehicle on one core: the paper's scenarios A-D driven whole, driver and powertrain
// included, three planes of 30 points. Counters: `real_time_factor`, simulated seconds per CPU
// second; `times_paper`, against the paper's own factor (Table 7: vehicle time / calculation time).

#include <benchmark/benchmark.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <dbd/core/vehicle_database.h>

namespace {

void DriveScenario(benchmark::State& state, const std::string& name) {
  const auto vehicle = dbd::LoadVehicle("tomcar-tm27");
  const dbd::Scenario scenario = dbd::MakeScenario(name);
  double simulated = 0;
  for (auto _ : state) {
    dbd::Simulation simulation = dbd::StartScenario(scenario, *vehicle);
    dbd::ScenarioDriver driver(scenario, *vehicle);
    while (simulation.time() < scenario.duration) driver.Advance(simulation);
    benchmark::DoNotOptimize(simulation.StateHash());
    simulated += scenario.duration;
  }
  const double paper_factor = scenario.duration / scenario.paper_time;
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  state.counters["times_paper"] =
      benchmark::Counter(simulated / paper_factor, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(DriveScenario, A, "A")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DriveScenario, B, "B")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DriveScenario, C, "C")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DriveScenario, D, "D")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
