#include "plan_request.h"

namespace dbd {

PlanRequest MakePlanRequest(const GivenEnd& start, const GivenEnd& goal, const Terrain& terrain) {
  const auto locate = [&terrain](const GivenEnd& end) {
    return LocatePlace(end.name, end.place, end.coordinates, terrain);
  };
  const LocalPlace from = locate(start), to = locate(goal);
  return {from.xy, from.yaw, to.xy, to.yaw};
}

}  // namespace dbd
