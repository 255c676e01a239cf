#include <dbd/core/error.h>
#include <dbd/planner/terrain_draw.h>
#include <gtest/gtest.h>

#include <cmath>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

Terrain Level(int columns, int rows) {
  return SurfaceTerrain(columns, rows, 1, [](double, double) { return 400.0; });
}

double ConeIndex(const Terrain& terrain) { return terrain.Soil(3, 3).cone_index; }

// 4,000 draws with a coefficient of variation of 0.2: the mean is known to 0.2 / sqrt(4000) =
// 0.3 %, the coefficient to about 0.2 / sqrt(8000) = 0.002 (a little more, as it is skewed).
TEST(DrawTerrain, SoilStrengthHasTheMeanAndTheSpreadOfItsMaterial) {
  const Terrain terrain = Level(8, 8);
  double sum = 0, squares = 0;
  constexpr int kDraws = 4000;
  for (int draw = 0; draw < kDraws; ++draw) {
    const double ratio = ConeIndex(DrawTerrain(terrain, {}, 1, draw)) / ConeIndex(terrain);
    EXPECT_GT(ratio, 0);
    sum += ratio, squares += ratio * ratio;
  }
  const double mean = sum / kDraws;
  EXPECT_NEAR(mean, 1, 0.012);
  EXPECT_NEAR(std::sqrt(squares / kDraws - mean * mean) / mean, 0.2, 0.01);
}

TEST(DrawTerrain, EveryMaterialHasAFactorOfItsOwn) {
  const Terrain terrain = DrawnTerrain({"..mm", "..mm", "..mm", "..mm"}, 2);
  const Terrain drawn = DrawTerrain(terrain, {}, 1, 0);
  const double ground = drawn.Soil(1, 1).cone_index / terrain.Soil(1, 1).cone_index;
  const double mud = drawn.Soil(6, 1).cone_index / terrain.Soil(6, 1).cone_index;
  EXPECT_NE(ground, 1);
  EXPECT_GT(std::abs(ground - mud), 1e-6);
}

TEST(DrawTerrain, TheSameDrawIsTheSameAndOthersDiffer) {
  const Terrain terrain = Level(30, 30);
  const TerrainSpread spread{1, 0.2, 5};
  const Terrain one = DrawTerrain(terrain, spread, 7, 3),
                again = DrawTerrain(terrain, spread, 7, 3);
  EXPECT_EQ(ConeIndex(one), ConeIndex(again));
  EXPECT_EQ(one.Height(12.3, 4.5), again.Height(12.3, 4.5));
  EXPECT_NE(one.Height(12.3, 4.5), DrawTerrain(terrain, spread, 7, 4).Height(12.3, 4.5));
  EXPECT_NE(one.Height(12.3, 4.5), DrawTerrain(terrain, spread, 8, 3).Height(12.3, 4.5));
}

TEST(DrawTerrain, WithoutSpreadNothingChanges) {
  const Terrain terrain = Level(8, 8);
  const Terrain drawn = DrawTerrain(terrain, {0, 0, 20}, 1, 5);
  EXPECT_EQ(ConeIndex(drawn), ConeIndex(terrain));
  EXPECT_EQ(drawn.Height(2.5, 3.5), terrain.Height(2.5, 3.5));
}

// Lattice of 5 m: at 1 m distance errors are nearly the same, at 25 m independent. 200 x 200 m hold
// (200 / 5)^2 = 1,600 nearly independent values: the standard deviation is known to a few percent.
TEST(DrawTerrain, HeightErrorsHaveTheirSizeAndAreAlikeNearby) {
  const Terrain terrain = Level(201, 201);
  const Terrain drawn = DrawTerrain(terrain, {1, 0.3, 5}, 1, 0);
  const auto error = [&](int x, int y) { return drawn.Height(x, y) - 400; };
  double squares = 0, near = 0, far = 0;
  int count = 0;
  for (int y = 0; y <= 175; ++y) {
    for (int x = 0; x <= 175; ++x, ++count) {
      squares += error(x, y) * error(x, y);
      near += error(x, y) * error(x + 1, y);
      far += error(x, y) * error(x + 25, y);
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.03);
  EXPECT_GT(near / squares, 0.95);
  EXPECT_LT(std::abs(far / squares), 0.15);
}

TEST(DrawTerrain, UnknownGroundStaysUnknown) {
  const Terrain terrain = DrawnTerrain({"....", "..?.", "....", "...."}, 1);
  const Terrain drawn = DrawTerrain(terrain, {1, 0.5, 2}, 1, 0);
  EXPECT_FALSE(drawn.heights().IsCellKnown(2, 2));
  EXPECT_TRUE(drawn.heights().IsCellKnown(0, 0));
}

TEST(DrawTerrain, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(DrawTerrain(Level(8, 8), {-1, 0, 20}, 1, 0), InputError);
  EXPECT_THROW(DrawTerrain(Level(8, 8), {1, -0.1, 20}, 1, 0), InputError);
  EXPECT_THROW(DrawTerrain(Level(8, 8), {1, 0.1, 0}, 1, 0), InputError);
}

}  // namespace
}  // namespace dbd
