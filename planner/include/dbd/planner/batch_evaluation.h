#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <stop_token>

namespace dbd {

/// Drives every candidate in full dynamics, in parallel; slot i of the result is candidate i.
///
/// Each rollout is one task that reads shared, immutable data and writes its own slot; nothing is
/// reduced in the order of arrival, so that the result does not depend on the number of threads.
/// `progress` is called from the calling thread's arena, one call at a time.
std::vector<Rollout> EvaluateRollouts(const Terrain& terrain, const VehicleModel& vehicle,
                                      const std::vector<Candidate>& candidates,
                                      const PlanOptions& options, const ProgressCallback& progress,
                                      std::stop_token stop);

}  // namespace dbd
