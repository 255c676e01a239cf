#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

/// Fills in status, chosen, reason and blocked_at from the driven and scored candidates: the
/// lowest score among the feasible, ties by index; else where and why the drives failed.
void ChooseRoute(Plan& plan);

}  // namespace dbd
