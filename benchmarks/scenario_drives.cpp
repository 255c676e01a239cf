#include "scenario_drives.h"

#include <cmath>
#include <map>
#include <vector>

namespace dbd {
namespace {

constexpr double kSettleTime = 1;           // [s], simulated like the drive
constexpr double kDecisionInterval = 0.04;  // [s] between decisions of a driver, as in plans

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

}  // namespace

const Terrain& ScenarioTerrain(const std::string& scenario, int cell_millimetres) {
  static std::map<std::pair<std::string, int>, Terrain> terrains;
  const std::pair key(scenario, cell_millimetres);
  const auto found = terrains.find(key);
  if (found != terrains.end()) return found->second;
  return terrains.emplace(key, Rasterise(*MakeScenario(scenario).ground, 1e-3 * cell_millimetres))
      .first->second;
}

double DriveAlone(const Scenario& scenario, const VehicleModel& vehicle, const Terrain& terrain,
                  const SimulationOptions& options) {
  Simulation simulation(vehicle, terrain, options);
  simulation.Place(Eigen::Vector2d::Zero(), 0, kSettleTime);
  ScenarioDriver driver(scenario, vehicle, kDecisionInterval);
  while (simulation.time() < scenario.duration) driver.Advance(simulation);
  return kSettleTime + scenario.duration;
}

double DriveLanes(const Scenario& scenario, const VehicleModel& vehicle, const Terrain& terrain,
                  LaneKind kind) {
  SimulationLanes lanes(vehicle, terrain, kind);
  const auto count = static_cast<std::size_t>(lanes.lanes());
  std::vector<Driver> drivers(count,
                              Driver(vehicle, Path(), {.target_speed = scenario.target_speed}));
  std::vector<DriverState> states(count);
  std::vector<DriverCommand> commands(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d start(0, 0.25 * static_cast<double>(i) - 2);
    lanes.Place(static_cast<int>(i), start, 0, kSettleTime);
    drivers[i].SetStart(start, 0);
  }
  const int decide_every = static_cast<int>(std::lround(kDecisionInterval / lanes.control_step()));
  for (int step = 0; lanes.time(0) < scenario.duration; ++step) {
    for (std::size_t i = 0; i < count && step % decide_every == 0; ++i) {
      const int lane = static_cast<int>(i);
      commands[i] = {.brake = 1};
      if (lanes.time(lane) < scenario.standing_time) continue;
      commands[i] = drivers[i].Update(lanes.ViewForDriver(lane),
                                      decide_every * lanes.control_step(), states[i]);
    }
    lanes.Advance(commands);
  }
  return (kSettleTime + scenario.duration) * static_cast<double>(count);
}

}  // namespace dbd
