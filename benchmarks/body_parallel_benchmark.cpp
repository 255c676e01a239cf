// Bodies in parallel inside one scene: columns of TM27 cars (5 bodies each) on rough ground, in
// lock-step, serial against two threads in the same run. Both advance the same scene by turns, so
// that a change of the machine's load meets both; times are wall-clock, medians over repetitions.
//
// Counters: `serial_us` and `parallel_us`, time per step of the whole scene; `speed_up`, their
// ratio; `forced_speed_up`, with threads whatever the executor's own measurements say, from which
// the cut-over is read; `shared`, which part of the rounds the executor chose to share.

#include <benchmark/benchmark.h>
#include <dbd/core/scenario.h>
#include <dbd/core/scene.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/body_executor.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace {

dbd::Scene MakeColumn(int bodies, const dbd::Ground& ground) {
  const auto car = dbd::LoadVehicle("tomcar-tm27");
  const int count = bodies / static_cast<int>(car->bodies.size());
  const auto driver = std::make_shared<const dbd::Driver>(
      *car, dbd::Path({{-10.0 * count - 10, 0}, {1e4, 0}}), dbd::DriverOptions{.target_speed = 5});
  std::vector<dbd::SceneVehicle> vehicles;
  for (int i = 0; i < count; ++i) {
    vehicles.push_back(
        {.model = car, .position = {-10.0 * i, 0}, .driver = driver, .ahead = i - 1});
  }
  return dbd::Scene(vehicles, ground, {.settle_time = 0.3});
}

/// Wall-clock seconds of one advance.
double Time(dbd::Scene& scene, double duration, dbd::LockstepExecutor& executor) {
  const auto start = std::chrono::steady_clock::now();
  scene.Advance(duration, executor);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

void Column(benchmark::State& state) {
  constexpr double kWork = 20e-3;  // [s] of one advance when one vehicle's step takes 1 us
  const int bodies = static_cast<int>(state.range(0));
  const auto ground = dbd::MakeRandomGround(-10.0 * bodies, 0.1, 0.5, 1);
  dbd::Scene scene = MakeColumn(bodies, *ground);
  const double steps = std::max(20.0, kWork * 1e6 / scene.vehicle_count());
  const double duration = steps * scene.step();
  dbd::SerialExecutor serial;
  dbd::BodyExecutor parallel({.threads = 2});
  dbd::BodyExecutor forced({.threads = 2, .least_items = 2, .adapt = false});
  scene.Advance(duration, parallel);  // warm
  std::vector<double> serial_times, gain, forced_gain;
  for (auto _ : state) {
    const double serial_time = Time(scene, duration, serial);
    serial_times.push_back(serial_time);
    gain.push_back(serial_time / Time(scene, duration, parallel));
    forced_gain.push_back(serial_time / Time(scene, duration, forced));
  }
  const double serial_us = 1e6 * Median(serial_times) / std::round(steps);
  state.counters["serial_us"] = serial_us;
  state.counters["parallel_us"] = serial_us / Median(gain);
  state.counters["speed_up"] = Median(gain);
  state.counters["forced_speed_up"] = Median(forced_gain);
  // Google Benchmark writes the variation of zeros as NaN, which is no JSON.
  if (parallel.parallel_share() > 0) state.counters["shared"] = parallel.parallel_share();
  state.counters["bytes_per_vehicle"] = static_cast<double>(scene.StateBytes(0));
}

BENCHMARK(Column)
    ->ArgName("bodies")
    ->Arg(5)
    ->Arg(40)
    ->Arg(80)
    ->Arg(320)
    ->Arg(1280)
    ->Arg(5000)
    ->Iterations(31)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
