#pragma once

#include <dbd/terrain/terrain_info.h>

#include <string>
#include <vector>

namespace dbd {

/// What a terrain is like, some lines.
std::string TerrainInfoText(const std::string& file, const TerrainInfo& info);

/// The same for programs (schema dbd.terrain_info/1). As many infos as files.
std::string TerrainInfoJson(const std::vector<std::string>& files,
                            const std::vector<TerrainInfo>& infos);

}  // namespace dbd
