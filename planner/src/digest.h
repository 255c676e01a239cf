#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

/// FNV-1a over everything of a plan that must be the same for any number of threads: all but the
/// timing.
std::uint64_t DigestOf(const Plan& plan);

}  // namespace dbd
