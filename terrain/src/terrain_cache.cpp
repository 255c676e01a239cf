#include <dbd/core/error.h>
#include <dbd/terrain/terrain_cache.h>
#include <dbd/terrain/tin_surface.h>

#include <filesystem>
#include <sstream>

namespace dbd {
namespace {

void AddFile(const std::string& path, std::ostream& key) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  const auto changed = std::filesystem::last_write_time(path, error);
  key << path << '\x1f';
  if (!error) key << size << '@' << changed.time_since_epoch().count();
  key << '\x1e';
}

void AddPlacement(const MapPlacement& placement, std::ostream& key) {
  key << placement.origin.x() << ',' << placement.origin.y() << ',' << placement.yaw << '|';
}

TerrainFiles WithoutPlaces(TerrainFiles files) {
  files.places.clear();
  files.wgs84_places.clear();
  return files;
}

}  // namespace

std::size_t MemoryOf(const Terrain& terrain) {
  return terrain.heights().memory_bytes() + terrain.materials().memory_bytes() +
         terrain.obstacles().memory_bytes() + (terrain.tin() ? terrain.tin()->memory_bytes() : 0);
}

std::string ContentKey(const TerrainFiles& files) {
  std::ostringstream key;
  key.precision(17);
  AddFile(files.elevation, key);
  for (const std::string& path : files.more_elevation) AddFile(path, key);
  key << '|' << files.elevation_band << '|' << files.crs << '|'
      << static_cast<int>(files.unknown_ground) << '|' << files.fill_distance << '|'
      << files.rasterise_tin << '|' << files.surface_cell_size << '|' << files.memory_limit << '|';
  AddPlacement(files.elevation_placement, key);
  AddFile(files.materials, key);
  AddFile(files.material_table, key);
  key << files.materials_band << '|' << files.material_field << '|' << files.default_material << '|'
      << files.unknown_material << '|' << (files.moisture ? static_cast<int>(*files.moisture) : -1)
      << '|';
  AddFile(files.obstacles, key);
  AddPlacement(files.obstacles_placement, key);
  AddFile(files.surface_model, key);
  key << static_cast<int>(files.unknown_space) << '|' << files.surface_threshold;
  return key.str();
}

TerrainCache::TerrainCache(double memory_limit, Loader loader)
    : memory_limit_(memory_limit), loader_(std::move(loader)) {}

std::shared_ptr<const Terrain> TerrainCache::LoadFromFiles(const TerrainFiles& files) {
  return LoadTerrain(files);
}

std::shared_ptr<const Terrain> TerrainCache::Get(const TerrainFiles& files) {
  const std::string key = ContentKey(files);
  std::promise<std::shared_ptr<const Terrain>> promise;
  Future shared;
  {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(key);
    if (found != entries_.end()) {
      uses_.splice(uses_.begin(), uses_, found->second.use);
      shared = found->second.terrain;
    } else {
      uses_.push_front(key);
      entries_.emplace(key, Entry{promise.get_future().share(), 0, uses_.begin()});
      ++loads_;
    }
  }
  try {
    return shared.valid() ? shared.get() : Load(key, WithoutPlaces(files), std::move(promise));
  } catch (const InputError&) {
    if (files.places.empty() && files.wgs84_places.empty()) throw;
  }
  return loader_(files);  // perhaps only the part around the places can be loaded
}

std::shared_ptr<const Terrain> TerrainCache::Load(
    const std::string& key, const TerrainFiles& files,
    std::promise<std::shared_ptr<const Terrain>> promise) {
  try {
    std::shared_ptr<const Terrain> terrain = loader_(files);
    Keep(key, MemoryOf(*terrain));
    promise.set_value(terrain);
    return terrain;
  } catch (...) {
    Forget(key);
    promise.set_exception(std::current_exception());
    throw;
  }
}

/// Makes room for it, or gives it up when it does not fit at all.
void TerrainCache::Keep(const std::string& key, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  entries_.at(key).bytes = bytes;
  bytes_ += bytes;
  for (auto use = uses_.end();
       use != uses_.begin() && static_cast<double>(bytes_) > memory_limit_;) {
    const auto entry = entries_.find(*--use);
    if (entry->second.bytes == 0) continue;  // its loader still needs it
    bytes_ -= entry->second.bytes;
    entries_.erase(entry);
    use = uses_.erase(use);
  }
}

void TerrainCache::Forget(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto entry = entries_.find(key);
  uses_.erase(entry->second.use);
  entries_.erase(entry);
}

std::size_t TerrainCache::loads() const {
  const std::lock_guard lock(mutex_);
  return loads_;
}

std::size_t TerrainCache::memory_bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace dbd
