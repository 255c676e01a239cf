#pragma once

#include <dbd/planner/planning_service.h>

#include <cstddef>
#include <string>

namespace dbd {

/// "route", "no_go", "deadline", "cancelled" or "error".
std::string StatusOf(const JobResult& result);

/// Why there is no plan, or what is to be said of it: one line of moderate length.
std::string ReasonOf(const JobResult& result);

/// One line of a result file (schema dbd.result/1), without a line break: the id and line of the
/// request, and the plan or the reason why there is none.
std::string BatchAnswer(std::size_t line, const std::string& id, const JobResult& result);

}  // namespace dbd
