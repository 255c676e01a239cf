#pragma once

#include <dbd/planner/extra_cost.h>
#include <dbd/planner/plan_types.h>
#include <dbd/planner/trafficability.h>

#include <vector>

namespace dbd {

/// What drives taught about the ground, as cost on top of the layer's: cones where drives failed,
/// which add up; cones where a limit was nearly used up, worth what the score charges for it; and
/// along every drive what it took longer than the layer had expected, beyond the ratio that is
/// common to all drives. Ground that nobody has tried costs nothing extra, so that the next search
/// tries it.
///
/// `layer` must be without lessons of its own. The drives' order changes nothing but round-off.
ExtraCost LearnFromRollouts(const TrafficabilityLayer& layer, const std::vector<Rollout>& rollouts,
                            const ScoringOptions& scoring);

}  // namespace dbd
