#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class LoadSurfaceModelTest : public testing::Test {
 protected:
  void SetUp() override {
    raster_.columns = raster_.rows = 10;
    raster_.value = [](int, int) { return 100.0; };
    files_.elevation = raster_.Write(directory_.File("dem.tif"));
    raster_.value = [](int column, int row) {
      if (column == 2 && row == 3) return 103.0;  // a tree
      return column == 6 ? 100.4 : 100.0;         // grass
    };
    files_.surface_model = raster_.Write(directory_.File("dsm.tif"));
  }

  static bool Blocks(const Terrain& terrain, double east, double south) {
    const Eigen::Vector2d local = terrain.frame().ToLocal({500000 + east, 5200000 - south});
    return terrain.obstacles().Blocks(local.x(), local.y(), 2);
  }

  TemporaryDirectory directory_;
  TestRaster raster_;
  TerrainFiles files_;
};

TEST_F(LoadSurfaceModelTest, MakesObstaclesOfWhatRisesAboveTheThreshold) {
  const auto terrain = LoadTerrain(files_);
  EXPECT_TRUE(Blocks(*terrain, 2.5, 3.5));
  EXPECT_FALSE(Blocks(*terrain, 6.5, 3.5));
  EXPECT_DOUBLE_EQ(terrain->obstacles().BlockedShare(2), 0.01);
  files_.surface_threshold = 0.3;
  EXPECT_TRUE(Blocks(*LoadTerrain(files_), 6.5, 3.5));
}

TEST_F(LoadSurfaceModelTest, RefusesASurfaceElsewhere) {
  raster_.transform[0] = 600000;
  files_.surface_model = raster_.Write(directory_.File("far.tif"));
  EXPECT_THAT(ErrorOf([this] { LoadTerrain(files_); }), HasSubstr("overlap"));
}

// The tree of the surface model and a rock of the OctoMap, each on cells of its own size.
TEST_F(LoadSurfaceModelTest, BlocksTogetherWithAnOctoMap) {
  octomap::OcTree tree(0.2);
  tree.updateNode(7.5, -1.5, 101.0, true);  // 7.5 m east, 1.5 m south of the corner
  files_.obstacles = directory_.File("rock.bt");
  tree.writeBinary(files_.obstacles);
  files_.obstacles_placement.origin = {500000, 5200000};
  const auto terrain = LoadTerrain(files_);
  EXPECT_TRUE(Blocks(*terrain, 2.5, 3.5));
  EXPECT_TRUE(Blocks(*terrain, 7.5, 1.5));
  EXPECT_FALSE(Blocks(*terrain, 8.5, 1.5));
  // 1 cell of 10 x 10 and the only voxel column.
  EXPECT_DOUBLE_EQ(terrain->obstacles().BlockedShare(2), 2.0 / 101.0);
  files_.surface_model.clear();
  EXPECT_FALSE(Blocks(*LoadTerrain(files_), 2.5, 3.5));
}

TEST(LoadSurfaceModel, FindsTheTreesOfARealPair) {
  TerrainFiles files;
  files.elevation = SharedFile("dem/tahoe_lidar_bareearth.tif");
  if (files.elevation.empty()) GTEST_SKIP() << "no shared data";
  files.surface_model = SharedFile("dem/tahoe_lidar_highesthit.tif");
  const auto terrain = LoadTerrain(files);
  EXPECT_GT(terrain->obstacles().BlockedShare(2), 0.1);
  EXPECT_LT(terrain->obstacles().BlockedShare(2), 0.8);
}

}  // namespace
}  // namespace dbd
