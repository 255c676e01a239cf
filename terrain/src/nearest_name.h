#pragma once

#include <string>
#include <vector>

namespace dbd {

/// The name with the fewest edits from `given`; empty when there are no names.
std::string NearestName(const std::string& given, const std::vector<std::string>& names);

/// "a, b, c"
std::string Join(const std::vector<std::string>& names);

}  // namespace dbd
