#include "lane_engine_includes.h"
#include "lane_measurement_pack.h"

namespace dbd {

LaneMeasurement MeasurePortable(bool scalar, const VehicleModel& vehicle, const Ground& ground,
                                const EngineState<double>& start) {
  if (scalar) return MeasureReal<double>(vehicle, ground, start);
  return MeasureReal<Pack<float, 4>>(vehicle, ground, start);
}

LaneMeasurement MeasureLanes(RooflineKind kind, const VehicleModel& vehicle, const Ground& ground,
                             const EngineState<double>& start) {
  switch (kind) {
    case RooflineKind::kScalar:
    case RooflineKind::kFloat4:
      return MeasurePortable(kind == RooflineKind::kScalar, vehicle, ground, start);
    case RooflineKind::kFloat8:
    case RooflineKind::kDouble4:
      return MeasureAvx2(kind == RooflineKind::kDouble4, vehicle, ground, start);
    case RooflineKind::kFloat16:
    case RooflineKind::kDouble8:
      return MeasureAvx512(kind == RooflineKind::kDouble8, vehicle, ground, start);
  }
  return {};
}

}  // namespace dbd
