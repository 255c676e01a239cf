#include <dbd/planner/layer_cache.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

std::shared_ptr<const Terrain> Level(int cells = 41) {
  return std::make_shared<const Terrain>(
      SurfaceTerrain(cells, cells, 1, [](double, double) { return 0.0; }));
}

TEST(LayerCache, MakesOneForAllWhoAskAtTheSameTime) {
  const auto terrain = Level(201);
  const auto vehicle = TestVehicle();
  LayerCache cache(1e9);
  std::vector<std::shared_ptr<const TrafficabilityLayer>> found(4);
  {
    std::vector<std::jthread> askers;
    for (auto& layer : found) {
      askers.emplace_back([&] { layer = cache.Get(terrain, vehicle, 8, {}); });
    }
  }
  EXPECT_EQ(cache.makes(), 1U);
  for (const auto& layer : found) EXPECT_EQ(layer, found[0]);
  EXPECT_EQ(cache.memory_bytes(), found[0]->memory_bytes());
}

TEST(LayerCache, TerrainVehicleAndSpeedMakeADifference) {
  const auto terrain = Level(), other = Level();
  const auto vehicle = TestVehicle(), another = TestVehicle();
  LayerCache cache(1e9);
  const auto layer = cache.Get(terrain, vehicle, 8, {});
  EXPECT_NE(cache.Get(other, vehicle, 8, {}), layer);
  EXPECT_NE(cache.Get(terrain, another, 8, {}), layer);
  EXPECT_NE(cache.Get(terrain, vehicle, 7, {}), layer);
  EXPECT_EQ(cache.Get(terrain, vehicle, 8, {}), layer);
  EXPECT_EQ(cache.makes(), 4U);
}

TEST(LayerCache, GivesUpTheOneAskedForLongestAgo) {
  const auto terrain = Level();
  const auto vehicle = TestVehicle();
  const double one = static_cast<double>(TrafficabilityLayer(*terrain, *vehicle, 8).memory_bytes());
  LayerCache cache(2.5 * one);
  for (const double speed : {1.0, 2.0, 1.0, 3.0, 1.0, 2.0}) cache.Get(terrain, vehicle, speed, {});
  EXPECT_EQ(cache.makes(), 4U);  // 1, 2, 3 instead of 2, 2 again
  EXPECT_EQ(cache.memory_bytes(), static_cast<std::size_t>(2 * one));
}

TEST(LayerCache, KeepsNothingOfATerrainThatIsGone) {
  auto terrain = Level();
  const auto vehicle = TestVehicle();
  LayerCache cache(1e9);
  cache.Get(terrain, vehicle, 8, {});
  terrain = Level(11);
  const auto small = cache.Get(terrain, vehicle, 8, {});
  EXPECT_EQ(cache.makes(), 2U);
  EXPECT_EQ(cache.memory_bytes(), small->memory_bytes());
}

TEST(LayerCache, OneThatIsStoppedLeavesTheLayerToOthers) {
  const auto terrain = Level();
  const auto vehicle = TestVehicle();
  LayerCache cache(1e9);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(cache.Get(terrain, vehicle, 8, stop.get_token()), StopRequested);
  EXPECT_TRUE(cache.Get(terrain, vehicle, 8, {}));
  EXPECT_EQ(cache.makes(), 2U);
}

}  // namespace
}  // namespace dbd
