#include "corner_engine.h"

#include <dbd/core/simulation_lanes.h>

namespace dbd {

CornerEngine::~CornerEngine() = default;

std::unique_ptr<CornerEngine> MakeCornerEngine(const EngineModel& engine, const Ground& ground) {
  const std::optional<Corners> corners = FindCorners(*engine.vehicle);
  if (!corners) return nullptr;
  if (LaneKindAvailable(LaneKind::kDouble8)) return MakeAvx512Corners(engine, *corners, ground);
  if (LaneKindAvailable(LaneKind::kDouble4)) return MakeAvx2Corners(engine, *corners, ground);
  return MakePortableCorners(engine, *corners, ground);
}

}  // namespace dbd
