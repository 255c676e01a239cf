#pragma once

#include <dbd/core/scenario.h>
#include <dbd/core/simulation_lanes.h>
#include <dbd/terrain/terrain.h>

#include <string>

namespace dbd {

// Whole drives of the paper's scenarios A-D on rasters, shared by benchmarks. Each returns the
// simulated seconds of all vehicles.

/// The ground of a scenario as a raster terrain, 70 m x 12 m; made once.
const Terrain& ScenarioTerrain(const std::string& scenario, int cell_millimetres);

/// One vehicle in double precision, driver and powertrain included.
double DriveAlone(const Scenario& scenario, const VehicleModel& vehicle, const Terrain& terrain,
                  const SimulationOptions& options = {});

/// Every lane drives the scenario on a track of its own.
double DriveLanes(const Scenario& scenario, const VehicleModel& vehicle, const Terrain& terrain,
                  LaneKind kind);

}  // namespace dbd
