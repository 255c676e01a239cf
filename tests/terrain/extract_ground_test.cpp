#include <dbd/terrain/terrain.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

// 40 m x 40 m of ground that rises by 1 in 10 to the east, in voxels of 0.2 m, with a wall, a tree
// crown, a bridge 4 m above the ground, and one reflection far below.
class ExtractGroundTest : public testing::Test {
 protected:
  static constexpr double kVoxel = 0.2;
  static double GroundAt(double x) { return 0.1 * x; }

  void SetUp() override {
    for (double x = 0.1; x < 40; x += kVoxel) {
      for (double y = 0.1; y < 40; y += kVoxel) Occupy(x, y, GroundAt(x));
    }
    Block(10, 10.4, 5, 25, 0, 3);
    Block(20, 24, 10, 14, 2, 5);
    Block(28, 32, 20, 30, 4, 4.4);
    Occupy(35, 35, -3);
    tree_.updateInnerOccupancy();
    files_.elevation = directory_.File("map.bt");
    tree_.writeBinary(files_.elevation);
  }

  void Occupy(double x, double y, double z) {
    tree_.updateNode(
        octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)), true,
        true);
  }

  // Above the ground.
  void Block(double x0, double x1, double y0, double y1, double z0, double z1) {
    for (double x = x0 + 0.1; x < x1; x += kVoxel) {
      for (double y = y0 + 0.1; y < y1; y += kVoxel) {
        for (double z = z0 + 0.1; z < z1; z += kVoxel) Occupy(x, y, GroundAt(x) + z);
      }
    }
  }

  octomap::OcTree tree_{kVoxel};
  TemporaryDirectory directory_;
  TerrainFiles files_;
};

TEST_F(ExtractGroundTest, FindsGroundUnderWhatStandsOnIt) {
  const auto terrain = LoadTerrain(files_);
  EXPECT_THAT(terrain->notes().at(0), HasSubstr("voxels of 0.2 m"));
  double worst = 0;
  for (double x = 2; x < 38; x += 0.7) {
    for (double y = 2; y < 38; y += 0.7) {
      const Eigen::Vector2d place = terrain->frame().ToLocal({x, y});
      ASSERT_TRUE(terrain->IsKnown(place.x(), place.y())) << x << ", " << y;
      worst = std::max(worst, std::abs(terrain->Height(place.x(), place.y()) - GroundAt(x)));
    }
  }
  // Half a voxel of rounding and what smoothing over a metre leaves of the steps.
  EXPECT_LT(worst, 0.75 * kVoxel);
}

TEST_F(ExtractGroundTest, DrivesUnderBridgesButNotThroughWalls) {
  const auto terrain = LoadTerrain(files_);
  const auto blocks = [&](double x, double y) {
    const Eigen::Vector2d place = terrain->frame().ToLocal({x, y});
    return terrain->obstacles().Blocks(place.x(), place.y(), 2.0);
  };
  EXPECT_TRUE(blocks(10.2, 15));
  EXPECT_FALSE(blocks(30, 25));
  EXPECT_FALSE(blocks(15, 30));
  const Eigen::Vector2d bridge = terrain->frame().ToLocal({30, 25});
  EXPECT_TRUE(terrain->obstacles().Blocks(bridge.x(), bridge.y(), 4.5));
}

TEST(ExtractGround, ReadsARealCampus) {
  TerrainFiles files;
  files.elevation = SharedFile("octomap/fr_campus.bt");
  if (files.elevation.empty()) GTEST_SKIP() << "no shared data";
  const auto terrain = LoadTerrain(files);
  EXPECT_GT(terrain->obstacles().BlockedShare(2), 0.01);
  EXPECT_LT(terrain->heights().unknown_share(), 0.9);
}

}  // namespace
}  // namespace dbd
