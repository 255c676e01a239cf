#pragma once

#include <dbd/core/scenario.h>
#include <dbd/core/trajectory.h>

#include <functional>
#include <vector>

namespace dbd {

/// Drives a scenario and keeps a row every 4 ms, as the reference trajectories do. With
/// `options.guide` the test rig pulls the vehicle, else engine and driver do. Ends early, with the
/// rows up to then, when the simulation becomes unstable. `observe` is called at every row, to keep
/// what rows do not hold.
std::vector<TrajectoryRow> RecordScenario(
    const Scenario& scenario, const VehicleModel& vehicle, const SimulationOptions& options = {},
    const std::function<void(const Simulation&)>& observe = {});

}  // namespace dbd
