#include <dbd/core/error.h>
#include <dbd/terrain/terrain_cache.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

Terrain Flat(int cells) {
  HeightMap::Grid grid;
  grid.columns = cells;
  grid.rows = cells;
  grid.cell_size = {1, 1};
  return Terrain(LocalFrame("", Eigen::Vector2d::Zero()),
                 HeightMap(grid, std::vector<float>(grid.CellCount(), 0.0F)),
                 MaterialMap(Material()), ObstacleMap());
}

TerrainFiles Named(const std::string& path) {
  TerrainFiles files;
  files.elevation = path;
  return files;
}

TEST(TerrainCache, LoadsOnceForAllWhoAskAtTheSameTime) {
  std::atomic<int> loads = 0;
  TerrainCache cache(1e9, [&](const TerrainFiles&) {
    ++loads;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return std::make_shared<const Terrain>(Flat(10));
  });
  std::vector<std::shared_ptr<const Terrain>> found(4);
  {
    std::vector<std::jthread> askers;
    for (auto& terrain : found) {
      askers.emplace_back([&] { terrain = cache.Get(Named("a")); });
    }
  }
  EXPECT_EQ(loads, 1);
  for (const auto& terrain : found) EXPECT_EQ(terrain, found[0]);
  EXPECT_EQ(cache.memory_bytes(), MemoryOf(*found[0]));
}

TEST(TerrainCache, GivesUpTheOneAskedForLongestAgo) {
  const double one = static_cast<double>(MemoryOf(Flat(50)));
  TerrainCache cache(2.5 * one,
                     [](const TerrainFiles&) { return std::make_shared<const Terrain>(Flat(50)); });
  for (const char* name : {"a", "b", "a", "c", "a", "b"}) cache.Get(Named(name));
  EXPECT_EQ(cache.loads(), 4U);  // a, b, c instead of b, b again instead of c
  EXPECT_EQ(cache.memory_bytes(), static_cast<std::size_t>(2 * one));
}

TEST(TerrainCache, HandsOutWhatIsTooLargeToKeep) {
  TerrainCache cache(10,
                     [](const TerrainFiles&) { return std::make_shared<const Terrain>(Flat(50)); });
  EXPECT_EQ(cache.Get(Named("a"))->heights().grid().columns, 50);
  EXPECT_EQ(cache.memory_bytes(), 0U);
}

TEST(TerrainCache, AFailureIsEverybodysAndNotKept) {
  int asked = 0;
  TerrainCache cache(1e9, [&](const TerrainFiles& files) -> std::shared_ptr<const Terrain> {
    if (++asked < 3) throw InputError(files.elevation + ": cannot be opened");
    return std::make_shared<const Terrain>(Flat(10));
  });
  EXPECT_THROW(cache.Get(Named("a")), InputError);
  EXPECT_THROW(cache.Get(Named("a")), InputError);
  EXPECT_NE(cache.Get(Named("a")), nullptr);
}

TEST(TerrainCache, OfALargeMapLoadsThePartAroundThePlaces) {
  TerrainCache cache(1e9, [](const TerrainFiles& files) -> std::shared_ptr<const Terrain> {
    if (files.places.empty()) throw InputError("needs 200 GB");
    return std::make_shared<const Terrain>(Flat(10));
  });
  TerrainFiles files = Named("a");
  EXPECT_THROW(cache.Get(files), InputError);
  files.places = {{1, 2}};
  EXPECT_NE(cache.Get(files), cache.Get(files));  // each request its own part
}

TEST(ContentKey, ChangesWithOptionsAndWithTheFile) {
  const TemporaryDirectory directory;
  const std::string path = directory.File("a.tif");
  std::ofstream(path) << "one";
  const std::string before = ContentKey(Named(path));
  EXPECT_EQ(ContentKey(Named(path)), before);
  TerrainFiles other = Named(path);
  other.crs = "EPSG:32633";
  EXPECT_NE(ContentKey(other), before);
  other = Named(path);
  other.moisture = MoistureState::kMoist;
  EXPECT_NE(ContentKey(other), before);
  other = Named(path);
  other.places = {{1, 2}};
  EXPECT_EQ(ContentKey(other), before);
  std::ofstream(path) << "longer";
  EXPECT_NE(ContentKey(Named(path)), before);
}

}  // namespace
}  // namespace dbd
