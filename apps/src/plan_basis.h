#pragma once

#include <string>
#include <vector>

#include "plan_command.h"

namespace dbd {

/// One thing that an answer rests on.
struct BasisItem {
  std::string what;    ///< "elevation", "vehicle", ...
  std::string name;    ///< as it was given
  std::string sha256;  ///< of the file; empty for what is built in
};

/// The files and built-in tables behind a plan, with the hashes of the files as they are now.
std::vector<BasisItem> FilesBehind(const PlanArguments& arguments);

}  // namespace dbd
