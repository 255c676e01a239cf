#pragma once

#include <dbd/core/scenario.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dbd {

/// The chassis in one scenario, at every control step.
inline std::vector<ChassisView> DriveScenario(const Scenario& scenario, const VehicleModel& vehicle,
                                              const SimulationOptions& options = {}) {
  Simulation simulation(vehicle, *scenario.ground, options);
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  ScenarioDriver driver(scenario, vehicle);
  std::vector<ChassisView> drive;
  while (simulation.time() < scenario.duration - 1e-9) {
    driver.Advance(simulation);
    drive.push_back(simulation.Chassis());
  }
  return drive;
}

/// Chassis height every 0.02 m from x = 1.5 m to `end`, by cubic interpolation, so that a small
/// error in speed does not count as one in height. Shorter where the drive ends before.
inline std::vector<double> HeightsAlong(const std::vector<ChassisView>& drive, double end) {
  std::vector<double> heights;
  const auto x_at = [&](std::size_t i) { return drive[i].p_WB.x(); };
  std::size_t i = 2;
  for (double x = 1.5; x < end; x += 0.02) {
    while (i + 1 < drive.size() && x_at(i) < x) ++i;
    if (i + 1 >= drive.size()) break;
    double height = 0;
    for (std::size_t a = i - 2; a <= i + 1; ++a) {
      double weight = 1;
      for (std::size_t b = i - 2; b <= i + 1; ++b) {
        if (b != a) weight *= (x - x_at(b)) / (x_at(a) - x_at(b));
      }
      height += weight * drive[a].p_WB.z();
    }
    heights.push_back(height);
  }
  return heights;
}

inline double RmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t n = std::min(a.size(), b.size());
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(n));
}

/// The vehicle with these integration steps [s]; control at its own 4 ms.
inline VehicleModel WithStepSizes(VehicleModel vehicle, double construction, double tire) {
  vehicle.steps = {construction, construction, tire, 4e-3};
  return vehicle;
}

}  // namespace dbd
