#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/planner/trafficability.h>

#include <cstdint>
#include <vector>

namespace dbd {

/// What was driven so far: three lists of the same length.
struct DrivenCandidates {
  const std::vector<Candidate>& candidates;
  const std::vector<Rollout>& rollouts;
  const std::vector<Score>& scores;
};

/// Variants of the best few of the driven candidates, to be driven in turn: with a bend to one side
/// where the drive was slow or came near to a limit, with smoother curves by what `layer` knows, or
/// slower before the place of the tightest limit. When none reached the goal, variants of those
/// that came farthest, about the places where they ended. All hold before the layer and can be
/// steered. Fewer than `count` when none of some tries holds. The same for the same seed.
std::vector<Candidate> VaryBest(const TrafficabilityLayer& layer, const VehicleModel& vehicle,
                                const DrivenCandidates& driven, int count, std::uint64_t seed);

}  // namespace dbd
