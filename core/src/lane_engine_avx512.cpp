#include "lane_engine_includes.h"

#ifdef DBD_WIDE_LANES
#define DBD_PACK_TARGET 512
#pragma GCC target("fma,avx512f,avx512vl,avx512dq,avx512bw")
#include "corner_engine_pack.h"
#include "lane_engine_pack.h"

namespace dbd {

std::unique_ptr<LaneEngine> MakeAvx512Lanes(LaneKind kind, const VehicleModel& vehicle,
                                            const Ground& ground) {
  if (kind == LaneKind::kDouble8)
    return std::make_unique<PackEngine<Pack<double, 8>>>(vehicle, ground);
  return std::make_unique<PackEngine<Pack<float, 16>>>(vehicle, ground);
}

std::unique_ptr<CornerEngine> MakeAvx512Corners(const EngineModel& engine, const Corners& corners,
                                                const Ground& ground) {
  return std::make_unique<PackCornerEngine<CornerPack>>(engine, corners, ground);
}

}  // namespace dbd
#else
#include "corner_engine.h"
#include "lane_engine.h"

namespace dbd {

std::unique_ptr<LaneEngine> MakeAvx512Lanes(LaneKind, const VehicleModel&, const Ground&) {
  return nullptr;
}

std::unique_ptr<CornerEngine> MakeAvx512Corners(const EngineModel&, const Corners&, const Ground&) {
  return nullptr;
}

}  // namespace dbd
#endif
