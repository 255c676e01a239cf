#include "decision_sites.h"

#include <dbd/terrain/generator.h>
#include <unistd.h>

#include <utility>

namespace dbd {
namespace {

namespace fs = std::filesystem;

constexpr double kSoft = 0.5;

Terrain Softened(const Terrain& terrain) {
  std::vector<Material> materials = terrain.materials().table().materials();
  for (Material& material : materials) material.soil.cone_index *= kSoft;
  return Terrain(terrain.frame(), terrain.heights(),
                 terrain.materials().WithMaterials(std::move(materials)), terrain.obstacles());
}

}  // namespace

std::vector<Site> GenerateSites(int count) {
  std::vector<Site> sites;
  for (int i = 1; i <= count; ++i) {
    const fs::path directory =
        fs::temp_directory_path() / ("dbd-decisions-" + std::to_string(getpid()));
    GeneratorOptions options;
    options.size = 300;
    options.relief = 25;
    options.seed = static_cast<std::uint64_t>(i);
    const GeneratedTerrain generated = GenerateTerrain(options, directory.string());
    auto terrain = LoadTerrain(FilesOf(generated));
    const bool soft = i % 2 == 0;
    if (soft) terrain = std::make_shared<const Terrain>(Softened(*terrain));
    sites.push_back({(soft ? "soft-" : "land-") + std::to_string(i), std::move(terrain)});
    fs::remove_all(directory);
  }
  return sites;
}

std::vector<Site> LoadSites(const fs::path& data) {
  std::vector<std::pair<std::string, TerrainFiles>> all;
  const auto add = [&](const char* name, const char* elevation) -> TerrainFiles& {
    all.emplace_back(name, TerrainFiles{});
    all.back().second.elevation = (data / "dem" / elevation).string();
    return all.back().second;
  };
  add("slovenia", "slovenia_TM1_564_146.tif");
  add("gabilan", "gabilan_1m.tif");
  add("avaAlr", "avaAlr_5m_holes.tif");
  TerrainFiles& lidr = add("lidr", "lidr_topography_dtm_1m.tif");
  lidr.materials = (data / "landcover/lidr_topography_material_1m.tif").string();
  lidr.material_table = "forest-ponds";
  lidr.obstacles = (data / "octomap/lidr_topography_obstacles_0.5m.bt").string();
  lidr.obstacles_placement.origin = {273357, 5274357};
  // Without its trees, among which no two places 60 m apart connect.
  add("tahoe", "tahoe_lidar_bareearth.tif");
  std::vector<Site> sites;
  for (const auto& [name, files] : all) {
    if (fs::exists(files.elevation)) sites.push_back({name, LoadTerrain(files)});
  }
  return sites;
}

}  // namespace dbd
