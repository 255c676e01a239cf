#pragma once

#include <stop_token>

namespace dbd {

/// Thrown out of the planner's long loops when a stop was asked for, to whoever handed in the
/// token. `PlanRoute` catches it and answers with the best so far.
struct StopRequested {};

inline void ThrowIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw StopRequested();
}

}  // namespace dbd
