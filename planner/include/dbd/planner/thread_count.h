#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

/// Threads to work with: those asked for, but no more than the process may have (TBB prints a
/// warning when an arena asks for more).
int ThreadCount(const PlanOptions& options);

}  // namespace dbd
