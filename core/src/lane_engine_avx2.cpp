#include "lane_engine_includes.h"

#ifdef DBD_WIDE_LANES
#define DBD_PACK_TARGET 2
#pragma GCC target("avx2,fma")
#include "corner_engine_pack.h"
#include "lane_engine_pack.h"

namespace dbd {

std::unique_ptr<LaneEngine> MakeAvx2Lanes(LaneKind kind, const VehicleModel& vehicle,
                                          const Ground& ground) {
  if (kind == LaneKind::kDouble4) {
    return std::make_unique<PackEngine<Pack<double, 4>>>(vehicle, ground);
  }
  if (kind == LaneKind::kFloat4) {
    return std::make_unique<PackEngine<Pack<float, 4>>>(vehicle, ground);
  }
  return std::make_unique<PackEngine<Pack<float, 8>>>(vehicle, ground);
}

std::unique_ptr<CornerEngine> MakeAvx2Corners(const EngineModel& engine, const Corners& corners,
                                              const Ground& ground) {
  return std::make_unique<PackCornerEngine<CornerPack>>(engine, corners, ground);
}

}  // namespace dbd
#else
#include "corner_engine.h"
#include "lane_engine.h"

namespace dbd {

std::unique_ptr<LaneEngine> MakeAvx2Lanes(LaneKind, const VehicleModel&, const Ground&) {
  return nullptr;
}

std::unique_ptr<CornerEngine> MakeAvx2Corners(const EngineModel&, const Corners&, const Ground&) {
  return nullptr;
}

}  // namespace dbd
#endif
