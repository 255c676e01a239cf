#pragma once

#include <string>
#include <vector>

#include "output_directory.h"
#include "plan_json.h"

namespace dbd {

/// "1.12 km in 3 min 24 s, mean 19.8 km/h, 0.51 kWh at the wheels".
std::string DriveTotals(const Rollout& rollout);

/// "roll 24.1°, limit 30.0° (20 % left), after 412 m at 564312.1, 146522.8", or "" without limits.
std::string TightestLimit(const Rollout& rollout, const LocalFrame& frame);

/// "32 candidates: 21 reached, 6 limit exceeded, 5 immobilized".
std::string OutcomeCounts(const std::vector<Rollout>& rollouts);

/// "sample 16: best 71.2 s, learn 8: best 68.0 s, learn 8: best 66.9 s": the best score after each
/// round.
std::string RoundGains(const std::vector<PlanRound>& rounds);

/// "on 31 of 32 draws of the terrain: P(go) 97 % (95 % interval 84 to 99 %), mean 43.4 s, slowest
/// tenth 46.0 s", or "" where nothing was drawn.
std::string SuccessOfRoute(const Plan& plan);

/// One line for the head of a map, and the smaller one below it.
std::string PlanHeadline(const PlanRecord& record);
std::string PlanSubtitle(const PlanRecord& record);

/// What a person wants to know of the plan, some lines.
std::string PlanSummary(const PlanRecord& record, const OutputDirectory& output);

/// "out: plan.json map.png ...".
std::string FilesWritten(const OutputDirectory& output);

}  // namespace dbd
