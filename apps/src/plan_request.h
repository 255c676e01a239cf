#pragma once

#include <dbd/planner/plan_types.h>

#include <string>

#include "places.h"

namespace dbd {

/// Start or goal as it was given; `name` begins what is said of it: "--start", "goal hut".
struct GivenEnd {
  std::string name;
  TypedPlace place;
  Coordinates coordinates = Coordinates::kMap;
};

/// Brings both ends into W. Throws InputError as LocatePlace does.
PlanRequest MakePlanRequest(const GivenEnd& start, const GivenEnd& goal, const Terrain& terrain);

}  // namespace dbd
