#pragma once

#include <string>
#include <vector>

namespace dbd {

/// What a file holds that its format does not have, one sentence each: KML elements that readers
/// pass over or take for what they resemble, GPX extensions without a namespace of their own. Few,
/// each once. `format` is OGR's name; formats other than GPX and KML have none, and neither have
/// files of more than 64 MB, which are not looked at.
std::vector<std::string> XmlOddities(const std::string& file, const std::string& format);

}  // namespace dbd
