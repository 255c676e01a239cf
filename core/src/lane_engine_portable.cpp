#include "corner_engine_pack.h"
#include "lane_engine_pack.h"

namespace dbd {

std::unique_ptr<LaneEngine> MakePortableLanes(LaneKind kind, const VehicleModel& vehicle,
                                              const Ground& ground) {
  if (kind == LaneKind::kDouble2)
    return std::make_unique<PackEngine<Pack<double, 2>>>(vehicle, ground);
  return std::make_unique<PackEngine<Pack<float, 4>>>(vehicle, ground);
}

std::unique_ptr<CornerEngine> MakePortableCorners(const EngineModel& engine, const Corners& corners,
                                                  const Ground& ground) {
  return std::make_unique<PackCornerEngine<CornerPack>>(engine, corners, ground);
}

}  // namespace dbd
