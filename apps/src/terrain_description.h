#pragma once

#include <dbd/terrain/file_info.h>
#include <dbd/terrain/terrain_info.h>

#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// A file and, when it can be driven on, the ground that it makes.
struct DescribedFile {
  std::string name;
  FileInfo file;
  std::optional<TerrainInfo> ground;
};

/// What the file holds and what the ground is like, some lines.
std::string TerrainInfoText(const DescribedFile& described);

/// The same for programs (schema dbd.terrain_info/2): "ground" is null where there is none.
std::string TerrainInfoJson(const std::vector<DescribedFile>& files);

}  // namespace dbd
