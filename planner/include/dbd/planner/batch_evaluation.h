#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/drive.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <functional>
#include <stop_token>

namespace dbd {

using RolloutCallback = std::function<void(const Rollout&)>;

/// How a candidate is driven to be judged.
DriveOptions DriveOptionsFor(const Candidate& candidate, const PlanOptions& options);

/// Drives every candidate in full dynamics, in parallel; slot i of the result is candidate i.
///
/// Every thread drives a pack of candidates at once and takes the next candidate whenever a lane is
/// free. What a lane does depends neither on its neighbours nor on the width of the pack, every
/// rollout has a slot of its own, and nothing is reduced in the order of arrival: the result does
/// not depend on the number of threads.
/// `on_done` gets every drive when it has ended, from any thread, one call at a time. Soon after
/// `stop` was asked to, what is still under way or has not begun ends with kCancelled.
std::vector<Rollout> EvaluateRollouts(const Terrain& terrain, const VehicleModel& vehicle,
                                      const std::vector<Candidate>& candidates,
                                      const PlanOptions& options, const RolloutCallback& on_done,
                                      std::stop_token stop);

}  // namespace dbd
