#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <string>

#include "plan_basis.h"
#include "plan_command.h"

namespace dbd {

/// A finished plan with everything that it answers. A view: what it refers to must outlive it.
struct PlanRecord {
  const PlanArguments& arguments;
  const Terrain& terrain;
  const VehicleModel& vehicle;
  const PlanRequest& request;
  const PlanOptions& options;
  const Plan& plan;
  std::vector<BasisItem> basis;  ///< files are hashed once, for all that is written

  /// The rollout of the chosen route; null when there is none.
  const Rollout* chosen() const {
    return plan.chosen ? &plan.rollouts[static_cast<std::size_t>(*plan.chosen)] : nullptr;
  }
};

/// The content of plan.json (schema dbd.plan/1).
std::string PlanJson(const PlanRecord& record);

}  // namespace dbd
