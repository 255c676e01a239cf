#include <dbd/terrain/obstacle_map.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <iterator>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

HeightMap FlatGround(float z) {
  const HeightMap::Grid grid = {21, 21, {-10, -10}, {1, 1}};
  return HeightMap(grid, std::vector<float>(grid.CellCount(), z));
}

class LoadObstaclesTest : public testing::Test {
 protected:
  void Fill(double x, double y, double z) { tree_.updateNode(x, y, z, true); }

  std::string Write(const std::string& name) {
    const std::string file = directory_.File(name);
    if (name.ends_with(".bt")) {
      tree_.writeBinary(file);
    } else {
      tree_.write(file);
    }
    return file;
  }

  octomap::OcTree tree_{0.5};
  TemporaryDirectory directory_;
};

TEST_F(LoadObstaclesTest, ProjectsOnTheGround) {
  Fill(2.25, 3.25, 101.25);  // spans z 101 to 101.5: 1 m above the ground at 100
  for (const char* name : {"a.bt", "a.ot"}) {
    const ObstacleMap map = LoadObstacles(Write(name), FlatGround(100), MapPlacement{});
    EXPECT_TRUE(map.Blocks(2.4, 3.1, 1.01)) << name;
    EXPECT_FALSE(map.Blocks(2.4, 3.1, 0.99)) << name;
    EXPECT_FALSE(map.Blocks(2.6, 3.1, 9)) << name;
  }
}

TEST_F(LoadObstaclesTest, TurnsByTheYaw) {
  Fill(4.25, 0.25, 101.25);
  // A quarter turn to the left takes (4.25, 0.25) to (-0.25, 4.25).
  const ObstacleMap map =
      LoadObstacles(Write("a.bt"), FlatGround(100), MapPlacement{{0, 0}, M_PI / 2});
  EXPECT_TRUE(map.Blocks(-0.25, 4.25, 1.5));
  EXPECT_FALSE(map.Blocks(4.25, 0.25, 1.5));
  // An eighth of a turn: the voxel's middle goes to 4.25 / sqrt(2) -+ 0.25 / sqrt(2).
  const ObstacleMap eighth =
      LoadObstacles(Write("a.bt"), FlatGround(100), MapPlacement{{0, 0}, M_PI / 4});
  EXPECT_TRUE(eighth.Blocks(2.83, 3.18, 1.5));
  EXPECT_FALSE(eighth.Blocks(2.83 + 1.2, 3.18, 1.5));
}

TEST_F(LoadObstaclesTest, BlocksUnseenSpaceOnlyWhenAsked) {
  for (double z = 100.25; z < 106; z += 0.5) tree_.updateNode(2.25, 3.25, z, false);
  Fill(8.25, 8.25, 101.25);
  const std::string file = Write("a.ot");
  const ObstacleMap free = LoadObstacles(file, FlatGround(100), MapPlacement{});
  EXPECT_FALSE(free.Blocks(-5, -5, 2));
  const ObstacleMap blocked =
      LoadObstacles(file, FlatGround(100), MapPlacement{}, 0.3, UnknownSpace::kBlocked);
  EXPECT_TRUE(blocked.Blocks(-5, -5, 2));
  EXPECT_FALSE(blocked.Blocks(2.25, 3.25, 2));
  EXPECT_TRUE(blocked.Blocks(8.25, 8.25, 2));
}

TEST_F(LoadObstaclesTest, MovesByTheOffset) {
  Fill(1002.25, 503.25, 101.25);
  const ObstacleMap map =
      LoadObstacles(Write("a.bt"), FlatGround(100), MapPlacement{{-1000, -500}, 0});
  EXPECT_TRUE(map.Blocks(2.25, 3.25, 2));
}

TEST_F(LoadObstaclesTest, TakesLowVoxelsForGround) {
  Fill(0.25, 0.25, 100.25);  // bottom on the ground
  Fill(4.25, 4.25, 100.25);
  Fill(4.25, 4.25, 100.75);  // bottom 0.5 m above it
  const ObstacleMap map = LoadObstacles(Write("a.bt"), FlatGround(100), MapPlacement{}, 0.3);
  EXPECT_FALSE(map.Blocks(0.25, 0.25, 3));
  EXPECT_TRUE(map.Blocks(4.25, 4.25, 0.6));
}

TEST_F(LoadObstaclesTest, RespectsPrunedLeaves) {
  // Eight voxels become one leaf of 1 m; its lower half is ground.
  for (double x : {0.25, 0.75}) {
    for (double y : {0.25, 0.75}) {
      for (double z : {100.25, 100.75}) Fill(x, y, z);
    }
  }
  const ObstacleMap map = LoadObstacles(Write("a.bt"), FlatGround(100), MapPlacement{});
  EXPECT_EQ(map.layers().front().grid().columns, 2);
  EXPECT_TRUE(map.Blocks(0.8, 0.8, 0.6));
  EXPECT_FALSE(map.Blocks(0.8, 0.8, 0.5));
}

TEST_F(LoadObstaclesTest, IsEmptyWithoutOccupiedVoxels) {
  EXPECT_TRUE(LoadObstacles(Write("a.ot"), FlatGround(0), MapPlacement{}).empty());
  tree_.updateNode(1.0, 1.0, 1.0, false);
  EXPECT_TRUE(LoadObstacles(Write("b.bt"), FlatGround(0), MapPlacement{}).empty());
}

TEST_F(LoadObstaclesTest, SaysWhenAllLieOutside) {
  Fill(500, 3, 1);
  EXPECT_THAT(ErrorOf([&] { LoadObstacles(Write("a.bt"), FlatGround(0), MapPlacement{}); }),
              HasSubstr("outside the terrain"));
}

TEST_F(LoadObstaclesTest, RefusesWhatIsNoTree) {
  const HeightMap ground = FlatGround(0);
  EXPECT_EQ(ErrorOf([&] { LoadObstacles("/no/file.bt", ground, MapPlacement{}); }),
            "/no/file.bt: no such file");
  const std::string text = directory_.Write("a.bt", "something else");
  EXPECT_THAT(ErrorOf([&] { LoadObstacles(text, ground, MapPlacement{}); }),
              HasSubstr("not an OctoMap"));
  const std::string color =
      directory_.Write("b.ot", "# Octomap OcTree file\nid ColorOcTree\nsize 1\nres 0.5\ndata\n");
  EXPECT_THAT(ErrorOf([&] { LoadObstacles(color, ground, MapPlacement{}); }),
              HasSubstr("ColorOcTree"));
  const std::string graph = SharedFile("octomap/spherical_scan.graph");
  if (!graph.empty()) {
    EXPECT_THAT(ErrorOf([&] { LoadObstacles(graph, ground, MapPlacement{}); }), HasSubstr(graph));
  }
}

// Cut off or filled with ones, which would nest nodes for ever.
TEST_F(LoadObstaclesTest, RefusesCorruptTreesSilently) {
  for (int k = 0; k < 200; ++k) Fill(0.5 * (k % 7), 0.5 * (k % 11), 0.5 * (k % 13));
  for (const char* name : {"a.bt", "a.ot"}) {
    std::ifstream stream(Write(name), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const std::size_t data = bytes.find("data\n") + 5;
    const auto message = [&](const std::string& damaged) {
      const std::string path = directory_.Write(name, damaged);
      return ErrorOf([&] { LoadObstacles(path, FlatGround(0), MapPlacement{}); });
    };
    testing::internal::CaptureStderr();
    EXPECT_THAT(message(bytes.substr(0, bytes.size() - 20)), HasSubstr("corrupt")) << name;
    EXPECT_THAT(message(bytes.substr(0, data) + std::string(100000, '\xff')), HasSubstr("corrupt"));
    EXPECT_THAT(message(bytes.substr(0, data - 6)), HasSubstr("corrupt"));
    for (std::size_t cut = 0; cut < data; cut += 3) message(bytes.substr(0, cut));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

}  // namespace
}  // namespace dbd
