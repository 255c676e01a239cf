#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <string>

#include "simulate_command.h"

namespace dbd {

/// A finished drive with what was asked. A view: what it refers to must outlive it.
struct SimulationRecord {
  const SimulateArguments& arguments;
  const Terrain& terrain;
  const VehicleModel& vehicle;
  const Path& path;  ///< empty: straight ahead
  Eigen::Vector2d start;
  double yaw = 0;
  const Rollout& rollout;
  bool completed = false;  ///< drove as far as it was asked to
};

/// The content of simulate.json (schema dbd.simulation/1).
std::string SimulationJson(const SimulationRecord& record);

}  // namespace dbd
