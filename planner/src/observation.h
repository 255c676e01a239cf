#pragma once

#include <dbd/core/simulation.h>
#include <dbd/core/sinkage.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

namespace dbd {

/// What the judge looks at: the trace's row, and facts that need no row.
struct Observation {
  TraceSample sample;
  bool on_known_ground = true;
  const Material* impassable = nullptr;  ///< the material under a wheel that must not be driven on
  bool hits_obstacle = false;
  double up = 1;  ///< cosine of the chassis' tilt
};

/// Looks at the vehicle as it is at one moment.
Observation Observe(const VehicleSnapshot& snapshot, const Terrain& terrain,
                    const VehicleModel& vehicle, const SinkageOptions& sinkage = {});

}  // namespace dbd
