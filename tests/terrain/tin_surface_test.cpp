#include <dbd/terrain/terrain.h>
#include <dbd/terrain/tin_surface.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;
using Triangles = std::vector<TinSurface::Triangle>;

// 10 m x 10 m at z = 2 + 0.1 x + 0.2 y, in two triangles of either winding.
std::vector<Eigen::Vector3d> SquareVertices() {
  return {{0, 0, 2}, {10, 0, 3}, {10, 10, 5}, {0, 10, 4}};
}
const Triangles kSquare = {{0, 1, 2}, {0, 3, 2}};

double HeightAt(const TinSurface& tin, double x, double y) {
  double z = std::nan("");
  return tin.FindHeight(x, y, &z) ? z : std::nan("");
}

TEST(TinSurface, InterpolatesInItsTriangles) {
  const TinSurface tin(SquareVertices(), kSquare);
  for (const auto& [x, y] : {std::pair{1.0, 0.5}, {0.5, 1.0}, {5.0, 5.0}, {0.0, 0.0}, {10., 10.}}) {
    EXPECT_NEAR(HeightAt(tin, x, y), 2 + 0.1 * x + 0.2 * y, 1e-5) << x << ", " << y;
  }
  EXPECT_TRUE(std::isnan(HeightAt(tin, -0.1, 5)));
  EXPECT_TRUE(std::isnan(HeightAt(tin, 5, 10.1)));
  EXPECT_EQ(tin.report().boundary_edges, 4U);
  EXPECT_EQ(tin.report().holes, 0U);
  EXPECT_EQ(tin.report().overlap_share, 0);
}

TEST(TinSurface, BoundsTheHeightsAround) {
  const TinSurface tin(SquareVertices(), kSquare);
  for (const double radius : {0.5, 3.0, 20.0}) {
    for (double x = -1; x < 12; x += 1.3) {
      double highest = -1e9;
      for (double dx = -radius; dx <= radius; dx += radius / 8) {
        const double z = HeightAt(tin, x + dx, 5);
        if (!std::isnan(z)) highest = std::max(highest, z);
      }
      EXPECT_GE(tin.HighestWithin(radius, x, 5), highest - 1e-5) << radius << " at " << x;
      EXPECT_LE(tin.HighestWithin(radius, x, 5), 5 + 1e-5);
    }
  }
}

TEST(TinSurface, AnswersAVehicleThatDiverged) {
  const TinSurface tin(SquareVertices(), kSquare);
  const double nowhere = std::nan(""), far = 1e300;
  EXPECT_TRUE(std::isnan(HeightAt(tin, nowhere, nowhere)));
  EXPECT_TRUE(std::isnan(HeightAt(tin, far, -far)));
  EXPECT_TRUE(std::isfinite(tin.HighestWithin(1, nowhere, nowhere)));
  EXPECT_TRUE(std::isfinite(tin.HighestWithin(1, far, -far)));
}

TEST(TinSurface, LeavesWallsOutAndTakesTheLowestSheet) {
  std::vector<Eigen::Vector3d> vertices = SquareVertices();
  Triangles triangles = kSquare;
  for (const Eigen::Vector3d& v : SquareVertices())
    vertices.push_back(v + Eigen::Vector3d(0, 0, 4));
  triangles.push_back({4, 5, 6});  // a roof over the half with x > y
  triangles.push_back({0, 1, 5});  // a wall under it
  const TinSurface tin(vertices, triangles);
  EXPECT_NEAR(HeightAt(tin, 8, 2), 3.2, 1e-5);
  EXPECT_EQ(tin.report().vertical, 1U);
  EXPECT_NEAR(tin.report().overlap_share, 0.5, 0.01);
}

TEST(TinSurface, CountsHoles) {
  // 3 x 3 squares without the middle one.
  std::vector<Eigen::Vector3d> vertices;
  Triangles triangles;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) vertices.emplace_back(x, y, 0);
  }
  for (std::uint32_t y = 0; y < 3; ++y) {
    for (std::uint32_t x = 0; x < 3; ++x) {
      if (x == 1 && y == 1) continue;
      const std::uint32_t v = 4 * y + x;
      triangles.push_back({v, v + 1, v + 5});
      triangles.push_back({v, v + 5, v + 4});
    }
  }
  const TinSurface tin(vertices, triangles);
  EXPECT_EQ(tin.report().holes, 1U);
  EXPECT_EQ(tin.report().boundary_edges, 16U);  // 12 outside, 4 round the hole
  EXPECT_TRUE(std::isnan(HeightAt(tin, 1.5, 1.5)));
}

TEST(TinSurface, RefusesWhatHasNoArea) {
  EXPECT_THAT(ErrorOf([] {
                TinSurface({{0, 0, 0}, {1, 1, 0}, {1, 1, 5}}, {{0, 1, 2}});
              }),
              HasSubstr("area seen from above"));
}

class LoadTinTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  TerrainFiles files_;
};

const char kObj[] = "v 0 0 2\nv 10 0 3\nv 10 10 5\nv 0 10 4\nf 1 2 3\nf 1 3 4\n";
const char kPly[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 2\n10 0 3\n10 10 5\n0 10 4\n3 0 1 2\n3 0 2 3\n";
const char kXyz[] = "x y z\n0 0 2\n10,0,3\n10 10 5\n0 10 4\n5 5 3.5\n";

TEST_F(LoadTinTest, DrivesOnMeshesAndPoints) {
  files_.elevation_placement.origin = {500000, 5200000};
  files_.crs = "EPSG:32633";
  for (const auto& [name, text] : {std::pair{"a.obj", kObj}, {"a.ply", kPly}, {"a.xyz", kXyz}}) {
    files_.elevation = directory_.Write(name, text);
    for (const bool rasterise : {false, true}) {
      files_.rasterise_tin = rasterise;
      const auto terrain = LoadTerrain(files_);
      EXPECT_EQ(terrain->tin() == nullptr, rasterise);
      const Eigen::Vector2d place = terrain->frame().ToLocal({500004, 5200003});
      EXPECT_NEAR(terrain->Height(place.x(), place.y()), 2 + 0.4 + 0.6, 1e-4) << name;
      EXPECT_TRUE(terrain->IsKnown(place.x(), place.y()));
      EXPECT_FALSE(terrain->IsKnown(place.x() + 7, place.y()));
      EXPECT_THAT(terrain->notes().at(0), HasSubstr("0 holes"));
    }
  }
}

// A roof of height min(x, 10 - x) as cells of 4 m: between x = 4 and 8 the raster runs straight
// from 4 m to 2 m and misses the ridge at x = 5 by 1.5 m. The gap is a triangle over that half of
// the raster's 8 m: a mean square of 0.5 * 1.5^2 / 3, the root 0.61 m.
TEST_F(LoadTinTest, SaysHowFarARasterLiesOff) {
  files_.elevation = directory_.Write("roof.obj",
                                      "v 0 0 0\nv 5 0 5\nv 10 0 0\nv 0 9 0\nv 5 9 5\nv 10 9 0\n"
                                      "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\n");
  files_.surface_cell_size = 4;
  EXPECT_THAT(LoadTerrain(files_)->notes(),
              testing::Contains(HasSubstr("cells of 4 m lacks its creases (0.61 m rms)")));
}

TEST_F(LoadTinTest, TurnsByTheYaw) {
  files_.elevation = directory_.Write("a.obj", kObj);
  files_.elevation_placement = {{100, 200}, M_PI / 2};
  const auto terrain = LoadTerrain(files_);
  // (4, 3) turned by a quarter to the left is (-3, 4).
  const Eigen::Vector2d place = terrain->frame().ToLocal({97, 204});
  EXPECT_NEAR(terrain->Height(place.x(), place.y()), 3, 1e-4);
}

TEST_F(LoadTinTest, RefusesWithOneLine) {
  const auto message = [this](const char* name, const char* text) {
    files_.elevation = directory_.Write(name, text);
    const std::string line = ErrorOf([this] { LoadTerrain(files_); });
    EXPECT_THAT(line, HasSubstr(name));
    EXPECT_EQ(line.find('\n'), std::string::npos);
    return line;
  };
  EXPECT_THAT(message("a.xyz", "1 2 3\n4 5\n"), HasSubstr("line 2"));
  EXPECT_THAT(message("b.xyz", "1 2 3\n1 2 4\n1 2 5\n"), HasSubstr("cannot be triangulated"));
  EXPECT_THAT(message("c.ply", "nothing"), HasSubstr("cannot be read as a mesh"));
  EXPECT_THAT(message("d.obj", "v 6500000 0 0\nv 6500001 0 0\nv 6500000 1 0\nf 1 2 3\n"),
              HasSubstr("100 km"));
  files_.crs = "EPSG:4326";
  EXPECT_THAT(message("e.obj", kObj), HasSubstr("projected one in metres"));
}

TEST(LoadTin, AgreesWithTheRasterOfARealOne) {
  TerrainFiles files;
  files.elevation = SharedFile("dem/lidr_topography_dtm_1m.tif");
  if (files.elevation.empty()) GTEST_SKIP() << "no shared data";
  const auto raster = LoadTerrain(files);
  files.elevation = SharedFile("mesh/lidr_topography_tin.ply");
  files.elevation_placement.origin = {273357, 5274357};
  const auto tin = LoadTerrain(files);
  files.elevation = SharedFile("pointcloud/lidr_topography_ground.xyz");
  files.elevation_placement = {};
  const auto points = LoadTerrain(files);
  // The raster was sampled from this TIN at its cell centres.
  double worst = 0;
  int compared = 0;
  for (int i = 0; i < 280 * 280; ++i) {
    const Eigen::Vector2d map(273360.5 + i % 280, 5274360.5 + i / 280);
    const Eigen::Vector2d a = raster->frame().ToLocal(map);
    const Eigen::Vector2d b = tin->frame().ToLocal(map);
    const Eigen::Vector2d c = points->frame().ToLocal(map);
    if (!raster->IsKnown(a.x(), a.y()) || !tin->IsKnown(b.x(), b.y())) continue;
    ++compared;
    const double height = tin->Height(b.x(), b.y());
    worst = std::max(worst, std::abs(height - raster->Height(a.x(), a.y())));
    EXPECT_NEAR(points->Height(c.x(), c.y()), height, 0.5);
  }
  EXPECT_GT(compared, 75000);
  EXPECT_LT(worst, 0.01);
}

}  // namespace
}  // namespace dbd
