#include "lane_engine_includes.h"
#include "lane_measurement.h"
#include "timing_mark.h"

#ifdef DBD_WIDE_LANES
#define DBD_PACK_TARGET 512
#pragma GCC target("avx512f,avx512vl,avx512dq,avx512bw,fma")
#include "lane_measurement_pack.h"

namespace dbd {

LaneMeasurement MeasureAvx512(bool doubles, const VehicleModel& vehicle, const Ground& ground,
                              const EngineState<double>& start) {
  if (doubles) return MeasureReal<Pack<double, 8>>(vehicle, ground, start);
  return MeasureReal<Pack<float, 16>>(vehicle, ground, start);
}

}  // namespace dbd
#else
namespace dbd {

LaneMeasurement MeasureAvx512(bool, const VehicleModel&, const Ground&,
                              const EngineState<double>&) {
  return {};
}

}  // namespace dbd
#endif
