#pragma once

#include <dbd/terrain/terrain.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dbd {

/// A terrain that routes are asked for on.
struct Site {
  std::string name;
  std::shared_ptr<const Terrain> terrain;
};

/// Landscapes of 300 m with soils, a brook and trees, from seeds 1, 2, ...; every other one with
/// soils of half their strength.
std::vector<Site> GenerateSites(int count);

/// Those of the real data sets that are in the directory: lidar and photogrammetric elevation, one
/// of them with soils and obstacles, one with a surface model.
std::vector<Site> LoadSites(const std::filesystem::path& data);

}  // namespace dbd
