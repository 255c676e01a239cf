#pragma once

#include <string>
#include <utility>
#include <vector>

namespace dbd {

/// This program and the libraries its answers depend on: (name, version).
std::vector<std::pair<std::string, std::string>> Versions();

}  // namespace dbd
