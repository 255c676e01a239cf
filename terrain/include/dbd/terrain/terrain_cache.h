#pragma once

#include <dbd/terrain/terrain.h>

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace dbd {

/// Terrains that several requests share: the same files with the same options are loaded once,
/// also when they are asked for at the same time. A file that has changed on disk (size or time)
/// is loaded anew. Safe to use from many threads.
class TerrainCache {
 public:
  using Loader = std::function<std::shared_ptr<const Terrain>(const TerrainFiles&)>;

  /// What is kept stays below `memory_limit` [bytes]; the terrain asked for longest ago goes first.
  /// One that is larger alone is handed out and not kept. Terrains in use live on.
  explicit TerrainCache(double memory_limit, Loader loader = LoadFromFiles);

  /// Throws what the loader throws, InputError that names the file. The places of a request count
  /// only where the map is too large to be loaded whole: then the part around them is loaded for
  /// this request alone.
  std::shared_ptr<const Terrain> Get(const TerrainFiles& files);

  std::size_t loads() const;         ///< so far
  std::size_t memory_bytes() const;  ///< of the terrains that are kept

 private:
  using Future = std::shared_future<std::shared_ptr<const Terrain>>;
  struct Entry {
    Future terrain;
    std::size_t bytes = 0;  // 0 while it is being loaded
    std::list<std::string>::iterator use;
  };

  static std::shared_ptr<const Terrain> LoadFromFiles(const TerrainFiles& files);
  std::shared_ptr<const Terrain> Load(const std::string& key, const TerrainFiles& files,
                                      std::promise<std::shared_ptr<const Terrain>> promise);
  void Keep(const std::string& key, std::size_t bytes);
  void Forget(const std::string& key);

  const double memory_limit_;
  const Loader loader_;
  mutable std::mutex mutex_;
  std::unordered_map<std::string, Entry> entries_;
  std::list<std::string> uses_;  // keys, latest first
  std::size_t bytes_ = 0;
  std::size_t loads_ = 0;
};

/// What a terrain takes in memory [bytes].
std::size_t MemoryOf(const Terrain& terrain);

/// Names everything that a terrain is made of but for places: equal keys, equal terrains. Files
/// count with path, size and time of the last change.
std::string ContentKey(const TerrainFiles& files);

}  // namespace dbd
