#include <dbd/terrain/generator.h>
#include <dbd/terrain/terrain.h>
#include <dbd/terrain/terrain_info.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

std::string Bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

GeneratorOptions Small() {
  GeneratorOptions options;
  options.size = 200;
  return options;
}

TEST(Generator, IsTheSameForTheSameSeed) {
  const TemporaryDirectory directory;
  testing::internal::CaptureStderr();
  const GeneratedTerrain a = GenerateTerrain(Small(), directory.File("a"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const GeneratedTerrain b = GenerateTerrain(Small(), directory.File("b"));
  GeneratorOptions other = Small();
  other.seed = 2;
  const GeneratedTerrain c = GenerateTerrain(other, directory.File("c"));
  EXPECT_EQ(Bytes(a.elevation), Bytes(b.elevation));
  EXPECT_EQ(Bytes(a.materials), Bytes(b.materials));
  EXPECT_EQ(Bytes(a.obstacles), Bytes(b.obstacles));
  EXPECT_EQ(a.start, b.start);
  EXPECT_NE(Bytes(a.elevation), Bytes(c.elevation));
}

TEST(Generator, MakesGroundToDriveOn) {
  const TemporaryDirectory directory;
  const GeneratedTerrain generated = GenerateTerrain({}, directory.File("a"));
  const auto terrain = LoadTerrain(FilesOf(generated));
  const TerrainInfo info = DescribeTerrain(*terrain);
  EXPECT_EQ(info.columns, 400);
  EXPECT_EQ(info.unknown_share, 0);
  EXPECT_NEAR(info.highest - info.lowest, 30, 2);
  EXPECT_LT(info.median_slope, 15 * std::numbers::pi / 180);
  EXPECT_LT(info.slope_99_percent, 35 * std::numbers::pi / 180);
  EXPECT_EQ(info.materials.size(), 4U);
  EXPECT_EQ(info.unknown_material_share, 0);
  EXPECT_TRUE(info.has_obstacles);
  EXPECT_GT(info.obstacle_share, 0);
}

TEST(Generator, KeepsStartAndGoalFree) {
  for (const bool walled : {false, true}) {
    const TemporaryDirectory directory;
    GeneratorOptions options = Small();
    options.walled_goal = walled;
    options.tree_density = 200;
    const GeneratedTerrain generated = GenerateTerrain(options, directory.File("a"));
    const auto terrain = LoadTerrain(FilesOf(generated));
    for (const Eigen::Vector2d& map : {generated.start, generated.goal}) {
      const Eigen::Vector2d place = terrain->frame().ToLocal(map);
      EXPECT_TRUE(terrain->IsKnown(place.x(), place.y()));
      EXPECT_FALSE(terrain->obstacles().BlocksBox(place, 0.3, {3, 3}, 5));
      EXPECT_GE(terrain->Soil(place.x(), place.y()).cone_index, 900e3);
    }
  }
}

// Along every ray from the centre the ground falls at least 3 m within a metre or two, and climbs
// again.
TEST(Generator, ClosesTheTrench) {
  const TemporaryDirectory directory;
  GeneratorOptions options = Small();
  options.walled_goal = true;
  const GeneratedTerrain generated = GenerateTerrain(options, directory.File("a"));
  const auto terrain = LoadTerrain(FilesOf(generated));
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.01) {
    double steepest_fall = 0;
    double steepest_climb = 0;
    for (double r = 15; r < 35; r += 0.25) {
      const auto height = [&](double radius) {
        return terrain->Height(radius * std::cos(angle), radius * std::sin(angle));
      };
      const double rise = height(r + 2) - height(r);
      steepest_fall = std::min(steepest_fall, rise);
      steepest_climb = std::max(steepest_climb, rise);
    }
    EXPECT_LT(steepest_fall, -3) << angle;
    EXPECT_GT(steepest_climb, 3) << angle;
  }
}

TEST(Generator, RefusesOptionsByName) {
  const auto message = [](auto&& change) {
    GeneratorOptions options;
    change(options);
    return ErrorOf([&] { options.Validate(); });
  };
  EXPECT_EQ(message([](auto& o) { o.size = 3; }), "size is 3, must be 64 to 8192 cells");
  EXPECT_THAT(message([](auto& o) { o.cell_size = std::nan(""); }), HasSubstr("cell_size"));
  EXPECT_THAT(message([](auto& o) { o.relief = -1; }), HasSubstr("relief"));
  EXPECT_THAT(message([](auto& o) { o.wavelength = 2; }), HasSubstr("wavelength"));
  EXPECT_THAT(message([](auto& o) { o.tree_density = 1e9; }), HasSubstr("tree_density"));
}

TEST(Generator, LeavesNothingBehindWhenItFails) {
  const TemporaryDirectory directory;
  const std::string file = directory.Write("taken", "x");
  EXPECT_THAT(ErrorOf([&] { GenerateTerrain(Small(), file); }), HasSubstr(file));
  // A directory where a file must go.
  std::filesystem::create_directories(directory.path() / "out" / "obstacles.bt.part" / "full");
  EXPECT_NE(ErrorOf([&] { GenerateTerrain(Small(), directory.File("out")); }), "");
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "out" / "dem.tif"));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "out" / "dem.tif.part"));
}

TEST(Generator, TakesFlatGroundAndNoTrees) {
  const TemporaryDirectory directory;
  GeneratorOptions options = Small();
  options.relief = 0;
  options.tree_density = 0;
  const auto terrain = LoadTerrain(FilesOf(GenerateTerrain(options, directory.File("a"))));
  EXPECT_TRUE(terrain->obstacles().empty());
  EXPECT_LT(terrain->heights().highest() - terrain->heights().lowest(), 1.3);
}

}  // namespace
}  // namespace dbd
