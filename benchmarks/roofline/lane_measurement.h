#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/vehicle_model.h>

#include <array>

#include "machine_peaks.h"

namespace dbd {

// Declared only: what is written over lane types may not be compiled before the instruction set is
// chosen.
template <class Real>
struct EngineState;

/// A timed drive of the engine alone, and what the machine could do just before and after.
struct LaneMeasurement {
  MachinePeaks peaks;
  double step_seconds = 0;  ///< CPU time of one vehicle's step: a pack's, shared by lanes
  std::array<double, 6> stage_share{};  ///< of that time, by `Stage`
  int lanes = 1;
  int lane_bytes = 8;
};

enum class RooflineKind { kScalar, kFloat4, kFloat8, kFloat16, kDouble4, kDouble8 };

/// `ground` is a grid; `start`: where each lane begins, but for tracks side by side. The processor
/// must have such lanes.
LaneMeasurement MeasureLanes(RooflineKind kind, const VehicleModel& vehicle, const Ground& ground,
                             const EngineState<double>& start);

// One per instruction set, in translation units of their own.
LaneMeasurement MeasurePortable(bool scalar, const VehicleModel& vehicle, const Ground& ground,
                                const EngineState<double>& start);
LaneMeasurement MeasureAvx2(bool doubles, const VehicleModel& vehicle, const Ground& ground,
                            const EngineState<double>& start);
LaneMeasurement MeasureAvx512(bool doubles, const VehicleModel& vehicle, const Ground& ground,
                              const EngineState<double>& start);

}  // namespace dbd
