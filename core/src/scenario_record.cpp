#include <dbd/core/scenario_record.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

constexpr double kRowInterval = 4e-3;  // [s]
constexpr double kSettleTime = 0.5;    // [s] the design pose is the equilibrium: little to do

}  // namespace

std::vector<TrajectoryRow> RecordScenario(const Scenario& scenario, const VehicleModel& vehicle,
                                          const SimulationOptions& options,
                                          const std::function<void(const Simulation&)>& observe) {
  Simulation simulation(vehicle, *scenario.ground, options);
  simulation.Place(Eigen::Vector2d::Zero(), 0, kSettleTime);
  ScenarioDriver driver(scenario, vehicle);
  const int every =
      std::max(1, static_cast<int>(std::lround(kRowInterval / simulation.control_step())));
  std::vector<TrajectoryRow> rows;
  const auto keep_row = [&] {
    rows.push_back(ObserveRow(simulation, vehicle));
    if (observe) observe(simulation);
  };
  keep_row();
  while (simulation.time() < scenario.duration && simulation.IsSane()) {
    for (int i = 0; i < every; ++i) {
      if (options.guide) {
        simulation.Advance({});
      } else {
        driver.Advance(simulation);
      }
    }
    keep_row();
  }
  return rows;
}

}  // namespace dbd
