#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include "plan_command.h"
#include "plan_json.h"

namespace dbd {

/// A plan made by hand on a slope of 200 m x 100 m: candidate 0 reaches the goal straight along
/// y = 50, candidate 1 stops half way along y = 60.
struct SyntheticPlan {
  PlanArguments arguments;
  Terrain terrain;
  VehicleModel vehicle;
  PlanRequest request;
  PlanOptions options;
  Plan plan;

  PlanRecord record() const { return {arguments, terrain, vehicle, request, options, plan}; }
};

inline constexpr char kUtm33[] = "EPSG:32633";

// `crs`: coordinate system of the map, empty for none. W's origin lies at 500000, 5000000.

/// 201 x 101 cells of 1 m that rise by 1 in 10 to the east.
Terrain MakeSlope(const std::string& crs);

SyntheticPlan MakePlan(const std::string& crs);

/// The same with no route: both candidates fail.
SyntheticPlan MakeNoGoPlan(const std::string& crs);

}  // namespace dbd
