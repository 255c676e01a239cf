#pragma once

#include <dbd/core/simulation_lanes.h>

#include <vector>

namespace dbd {

/// The float lanes of this processor between which a vehicle may be taken, from narrow to wide.
inline std::vector<LaneKind> KindsWithTheSameBits() {
  std::vector<LaneKind> kinds;
  for (const LaneKind kind : {LaneKind::kFloat4, LaneKind::kFloat8, LaneKind::kFloat16}) {
    if (LaneKindAvailable(kind)) kinds.push_back(kind);
  }
  if (kinds.empty()) kinds.push_back(LaneKind::kFloat4Plain);
  return kinds;
}

}  // namespace dbd
