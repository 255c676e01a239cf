#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/vehicle_model.h>

#include <array>

#include "operation_counts.h"

namespace dbd {

/// Operations per step, of each stage; see `Stage`. Per pack: once for all its lanes.
using StageCounts = std::array<OperationCounts, 6>;

/// Mean over a drive on `ground`, which is a grid of cells smaller than a tire. `lanes`: 1, 4, 8
/// or 16. What one vehicle needs differs from what a pack does: a pack also does what only its
/// neighbours need.
StageCounts CountStages(const VehicleModel& vehicle, const Ground& ground, int lanes);

}  // namespace dbd
