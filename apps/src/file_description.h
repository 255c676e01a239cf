#pragma once

#include <dbd/terrain/file_info.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace dbd {

/// What a file holds, some lines for people, each indented by two.
std::string FileInfoText(const FileInfo& info);

/// The same for programs.
nlohmann::ordered_json FileInfoJson(const FileInfo& info);

}  // namespace dbd
