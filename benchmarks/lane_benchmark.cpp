// Speed of packs of vehicles on one core: the paper's scenarios A-D driven whole by every lane of a
// pack, driver and powertrain included, on a raster of 0.02 m or 1 m cells. `real_time_factor`:
// simulated seconds of all lanes per CPU second. `DriveAlone` is the double-precision reference on
// the same raster: the ratio of the two is what lanes gain. `DriveWheelLanes` is one vehicle whose
// four wheels are the lanes.

#include <benchmark/benchmark.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation_lanes.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/terrain/terrain.h>

#include <map>
#include <string>

namespace dbd {
namespace {

/// The ground of a scenario as a raster terrain, 70 m x 12 m.
Terrain Rasterise(const Ground& ground, double cell) {
  HeightMap::Grid grid;
  grid.columns = static_cast<int>(70 / cell);
  grid.rows = static_cast<int>(12 / cell);
  grid.first_center = {-10, -6};
  grid.cell_size = {cell, cell};
  std::vector<float> heights;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d p = grid.Center(column, row);
      heights.push_back(static_cast<float>(ground.Height(p.x(), p.y())));
    }
  }
  Material firm;
  firm.name = "firm";
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()), HeightMap(grid, heights),
                 MaterialMap(firm), ObstacleMap());
}

const Terrain& TerrainOf(const std::string& scenario, int millimetres) {
  static std::map<std::pair<std::string, int>, Terrain> terrains;
  const std::pair key(scenario, millimetres);
  const auto found = terrains.find(key);
  if (found != terrains.end()) return found->second;
  return terrains.emplace(key, Rasterise(*MakeScenario(scenario).ground, 1e-3 * millimetres))
      .first->second;
}

void SetRate(benchmark::State& state, double simulated) {
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

void DriveOne(benchmark::State& state, const std::string& name, int millimetres, bool wheel_lanes) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = TerrainOf(name, millimetres);
  const Scenario scenario = MakeScenario(name);
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    Simulation simulation(*vehicle, terrain, {.wheel_lanes = wheel_lanes});
    simulation.Place(Eigen::Vector2d::Zero(), 0);
    ScenarioDriver driver(scenario, *vehicle);
    while (simulation.time() < scenario.duration) driver.Advance(simulation);
    simulated += scenario.duration;
  }
  SetRate(state, simulated);
}

/// Every lane drives the scenario on a track of its own.
void DriveLanes(benchmark::State& state, const std::string& name, int millimetres, LaneKind kind) {
  if (!LaneKindAvailable(kind)) {
    state.SkipWithError("this processor has no such lanes");
    return;
  }
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Terrain& terrain = TerrainOf(name, millimetres);
  const Scenario scenario = MakeScenario(name);
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    SimulationLanes lanes(*vehicle, terrain, kind);
    const auto count = static_cast<std::size_t>(lanes.lanes());
    std::vector<Driver> drivers(count,
                                Driver(*vehicle, Path(), {.target_speed = scenario.target_speed}));
    std::vector<DriverState> states(count);
    std::vector<DriverCommand> commands(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector2d start(0, 0.25 * static_cast<double>(i) - 2);
      lanes.Place(static_cast<int>(i), start, 0);
      drivers[i].SetStart(start, 0);
    }
    while (lanes.time(0) < scenario.duration) {
      for (std::size_t i = 0; i < count; ++i) {
        const int lane = static_cast<int>(i);
        commands[i] = {.brake = 1};
        if (lanes.time(lane) < scenario.standing_time) continue;
        commands[i] = drivers[i].Update(lanes.ViewForDriver(lane), lanes.control_step(), states[i]);
      }
      lanes.Advance(commands);
    }
    simulated += scenario.duration * static_cast<double>(count);
  }
  SetRate(state, simulated);
}

void Register(const std::string& name, int millimetres) {
  const std::string where = name + "/" + std::to_string(millimetres) + "mm";
  benchmark::RegisterBenchmark(("DriveAlone/" + where).c_str(), DriveOne, name, millimetres, false)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("DriveWheelLanes/" + where).c_str(), DriveOne, name, millimetres,
                               true)
      ->Unit(benchmark::kMillisecond);
  for (const LaneKind kind : {LaneKind::kFloat16, LaneKind::kFloat8, LaneKind::kFloat4,
                              LaneKind::kDouble8, LaneKind::kDouble4}) {
    std::string lanes = LaneKindName(kind);
    std::erase(lanes, ' ');
    benchmark::RegisterBenchmark(("DriveLanes/" + where + "/" + lanes).c_str(), DriveLanes, name,
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
