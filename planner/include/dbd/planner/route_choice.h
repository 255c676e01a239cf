#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

/// Fills in status, chosen, reason and blocked_at from the driven and scored candidates: the
/// lowest score among the feasible, ties by index; else where and why the drives failed.
/// Where candidates were driven on draws, only those count that reached the goal on at least
/// `uncertainty.min_success` of them, and the least expected cost is chosen.
/// `stopped`: kDeadline or kCancelled when planning ended before its end; the choice is then the
/// best so far.
void ChooseRoute(Plan& plan, const UncertaintyOptions& uncertainty,
                 std::optional<PlanStatus> stopped = std::nullopt);

}  // namespace dbd
