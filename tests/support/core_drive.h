#pragma once

#include <dbd/core/simulation.h>

namespace dbd {

/// Stands with the brakes on.
inline void Stand(Simulation& simulation, double time) {
  const double end = simulation.time() + time;
  while (simulation.time() < end) simulation.Advance({.brake = 1});
}

/// Follows a driver for some time; `watch(simulation)` is called after every control step.
template <class Watch>
void Follow(const Driver& driver, Simulation& simulation, double time, Watch watch) {
  DriverState state;
  const double end = simulation.time() + time;
  while (simulation.time() < end) {
    simulation.Advance(driver.Update(simulation.ViewForDriver(), simulation.control_step(), state));
    watch(simulation);
  }
}

}  // namespace dbd
