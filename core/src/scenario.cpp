#include <dbd/core/error.h>
#include <dbd/core/scenario.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

// The paper gives the obstacle once as 200 mm radius (section 6.4) and once as 200 mm diameter
// (Table 7's text): the latter is used. Where it lies, and the node spacing of the random roads,
// are not printed: chosen.
constexpr double kObstacleX = 15.0;
constexpr double kObstacleRadius = 0.1;
constexpr double kRoadBegin = 3.0;
constexpr double kNodeSpacing = 0.5;

Scenario Describe(const std::string& name, std::uint64_t seed) {
  Scenario s;
  s.name = name;
  if (name == "A") {
    s = {name, "half-round obstacle, 200 mm diameter", 5, 2, 11, 5.0, nullptr};
    s.ground = MakeBumpGround(kObstacleX, kObstacleRadius);
  } else if (name == "B") {
    s = {name, "five waves of 5 m length and 100 mm amplitude", 2, 2, 20, 8.1, nullptr};
    s.ground = MakeSineGround(5, 30, 0.1, 5);
  } else if (name == "C") {
    s = {name, "fine roughness, random heights up to 100 mm", 2, 2, 10, 4.7, nullptr};
    s.ground = MakeRandomGround(kRoadBegin, 0.1, kNodeSpacing, seed);
  } else if (name == "D") {
    s = {name, "coarse roughness, random heights up to 200 mm", 2, 2, 10, 4.7, nullptr};
    s.ground = MakeRandomGround(kRoadBegin, 0.2, kNodeSpacing, seed);
  }
  return s;
}

}  // namespace

std::vector<std::string> ScenarioNames() { return {"A", "B", "C", "D"}; }

Scenario MakeScenario(const std::string& name, std::uint64_t seed) {
  Scenario scenario = Describe(name, seed);
  if (scenario.ground == nullptr) {
    throw InputError("scenario \"" + name + "\" is not known; there are A, B, C and D");
  }
  return scenario;
}

Simulation StartScenario(const Scenario& scenario, const VehicleModel& vehicle,
                         const SimulationOptions& options) {
  Simulation simulation(vehicle, *scenario.ground, options);
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  return simulation;
}

ScenarioDriver::ScenarioDriver(const Scenario& scenario, const VehicleModel& vehicle,
                               double decision_interval)
    : standing_time_(scenario.standing_time),
      decision_interval_(decision_interval),
      driver_(vehicle, Path(), {.target_speed = scenario.target_speed}) {
  driver_.SetStart(Eigen::Vector2d::Zero(), 0);
}

void ScenarioDriver::Advance(Simulation& simulation) {
  if (steps_to_decision_ == 0) {
    const double step = simulation.control_step();
    steps_to_decision_ = std::max(1, static_cast<int>(std::lround(decision_interval_ / step)));
    command_ = Decide(simulation, steps_to_decision_ * step);
  }
  --steps_to_decision_;
  simulation.Advance(command_);
}

DriverCommand ScenarioDriver::Decide(const Simulation& simulation, double dt) {
  if (simulation.time() < standing_time_) return {.brake = 1};
  return driver_.Update(simulation.ViewForDriver(), dt, state_);
}

}  // namespace dbd
