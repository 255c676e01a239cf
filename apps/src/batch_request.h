#pragma once

#include <string>

#include "places.h"
#include "plan_command.h"

namespace dbd {

/// One line of a request file (schema dbd.request/1): what `dbd plan` is asked with flags.
struct BatchRequest {
  std::string id;
  PlanArguments plan;  ///< but for its ends and its output
  TypedPlace start;
  TypedPlace goal;
  int priority = 0;
};

/// Longest line that is read [bytes].
inline constexpr std::size_t kLongestRequest = 1 << 20;

/// `origin`: what messages begin with, such as "line 12". Throws InputError.
BatchRequest ParseBatchRequest(const std::string& line, const std::string& origin);

/// The id of a request whose other content may be wrong; empty when it has none.
std::string FindRequestId(const std::string& line);

}  // namespace dbd
