#include <benchmark/benchmark.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/drive.h>
#include <dbd/terrain/terrain.h>
#include <dbd/terrain/tin_surface.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// Time of a height, and of a height with the three queries that its normal takes, on the same
// 60 m x 60 m of rolling ground as rasters of different resolution and as a TIN.

namespace dbd {
namespace {

constexpr double kSide = 60;  // [m]

double GroundAt(double x, double y) { return std::sin(0.3 * x) + std::cos(0.2 * y); }

HeightMap MakeRaster(double cell) {
  const int cells = static_cast<int>(kSide / cell) + 1;
  const HeightMap::Grid grid{cells, cells, {0, 0}, {cell, cell}};
  std::vector<float> heights;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      heights.push_back(static_cast<float>(GroundAt(column * cell, row * cell)));
    }
  }
  return HeightMap(grid, heights);
}

TinSurface MakeTin(double spacing) {
  const auto across = static_cast<std::uint32_t>(kSide / spacing) + 1;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TinSurface::Triangle> triangles;
  for (std::uint32_t row = 0; row < across; ++row) {
    for (std::uint32_t column = 0; column < across; ++column) {
      vertices.emplace_back(column * spacing, row * spacing,
                            GroundAt(column * spacing, row * spacing));
      if (row == 0 || column == 0) continue;
      const std::uint32_t v = row * across + column;
      triangles.push_back({v - across - 1, v - across, v});
      triangles.push_back({v - across - 1, v, v - 1});
    }
  }
  return TinSurface(std::move(vertices), std::move(triangles));
}

// Along a drive: 16 places of a wheel that moves on by 2 cm; or scattered over the ground.
struct Places {
  static constexpr int kWheel = 16;
  std::vector<double> x;
  std::vector<double> y;
};

Places MakePlaces(bool scattered) {
  Places places;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(1, kSide - 1);
  for (int i = 0; i < 2500 * Places::kWheel; ++i) {
    const double driven = 5 + 0.02 * (i / Places::kWheel);
    const double along = 0.05 * (i % Places::kWheel);
    places.x.push_back(scattered ? anywhere(random) : driven + along);
    places.y.push_back(scattered ? anywhere(random) : 20 + 0.3 * driven);
  }
  return places;
}

void SetRate(benchmark::State& state, std::size_t queries) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(queries));
}

// Arguments: cell size [mm], scattered.
void RasterHeights(benchmark::State& state) {
  const HeightMap map = MakeRaster(1e-3 * static_cast<double>(state.range(0)));
  const Places places = MakePlaces(state.range(1) != 0);
  double z[Places::kWheel];
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < places.x.size(); i += Places::kWheel) {
      map.Heights(Places::kWheel, &places.x[i], &places.y[i], z);
      benchmark::DoNotOptimize(z);
    }
  }
  SetRate(state, places.x.size());
}
BENCHMARK(RasterHeights)->ArgsProduct({{1000, 100, 20}, {0, 1}})->ArgNames({"mm", "scattered"});

void RasterHeightAndNormal(benchmark::State& state) {
  const HeightMap map = MakeRaster(1e-3 * static_cast<double>(state.range(0)));
  const Places places = MakePlaces(state.range(1) != 0);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < places.x.size(); ++i) {
      const double x[] = {places.x[i], places.x[i] + 0.1, places.x[i]};
      const double y[] = {places.y[i], places.y[i], places.y[i] + 0.1};
      double z[3];
      map.Heights(3, x, y, z);
      benchmark::DoNotOptimize(z);
    }
  }
  SetRate(state, places.x.size());
}
BENCHMARK(RasterHeightAndNormal)
    ->ArgsProduct({{1000, 100, 20}, {0, 1}})
    ->ArgNames({"mm", "scattered"});

void TinHeights(benchmark::State& state) {
  const TinSurface tin = MakeTin(1e-3 * static_cast<double>(state.range(0)));
  const Places places = MakePlaces(state.range(1) != 0);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < places.x.size(); ++i) {
      double z = 0;
      benchmark::DoNotOptimize(tin.FindHeight(places.x[i], places.y[i], &z));
    }
  }
  SetRate(state, places.x.size());
}
BENCHMARK(TinHeights)->ArgsProduct({{1000, 100}, {0, 1}})->ArgNames({"mm", "scattered"});

// A vehicle driven across, on a raster (argument: cell size [mm]) or on a TIN (negative: spacing).
// The rate is simulated seconds per second: the real-time factor.
void Rollout(benchmark::State& state) {
  const double size = 1e-3 * static_cast<double>(std::abs(state.range(0)));
  Terrain terrain(LocalFrame("", Eigen::Vector2d::Zero()),
                  MakeRaster(state.range(0) > 0 ? size : 0.5), MaterialMap(Material()),
                  ObstacleMap());
  if (state.range(0) < 0) terrain.set_tin(std::make_shared<const TinSurface>(MakeTin(size)));
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Path path({{5, 20}, {50, 33}});
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    simulated += DrivePath(terrain, *vehicle, path, path.Position(0), path.Heading(0), {}).time;
  }
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
BENCHMARK(Rollout)->ArgsProduct({{1000, 100, 20, -1000, -100}})->ArgName("mm");

// A vehicle's box, 4 m x 2 m, over obstacles on one cell in a hundred.
void ClearanceOfABox(benchmark::State& state) {
  const double cell = 1e-3 * static_cast<double>(state.range(0));
  const int cells = static_cast<int>(kSide / cell);
  const HeightMap::Grid grid{cells, cells, {0, 0}, {cell, cell}};
  std::mt19937 random(1);
  std::vector<float> lowest(grid.CellCount(), std::numeric_limits<float>::infinity());
  for (float& height : lowest) {
    if (random() % 100 == 0) height = 2.5F;  // a branch that the vehicle passes under
  }
  const ObstacleMap map(grid, std::move(lowest));
  const Places places = MakePlaces(state.range(1) != 0);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < places.x.size(); i += Places::kWheel) {
      benchmark::DoNotOptimize(map.BlocksBox({places.x[i], places.y[i]}, 0.3, {2, 1}, 2.0));
    }
  }
  SetRate(state, places.x.size() / Places::kWheel);
}
BENCHMARK(ClearanceOfABox)->ArgsProduct({{500, 200}, {0, 1}})->ArgNames({"mm", "scattered"});

}  // namespace
}  // namespace dbd

BENCHMARK_MAIN();
