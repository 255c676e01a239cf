#include <benchmark/benchmark.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/batch_evaluation.h>
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

// What questions to the ground cost, on the same 60 m x 60 m of rolling ground as rasters of
// different resolution and as a TIN, and what drives on it cost.

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

constexpr int kWheel = 16;  // places of a wheel's print

enum Where { kEastward, kNorthward, kScattered };

// Places of a wheel that moves on by 2 cm, across the ground and across it again, along the rows of
// a raster or across them; or scattered by an additive recurrence. Made as they are needed: a list
// of them would take the place in the cache that a drive leaves to the ground.
class Places {
 public:
  explicit Places(std::int64_t where) : where_(where) {}

  void Next(double* x, double* y) {
    if (where_ == kScattered) {
      for (int i = 0; i < kWheel; ++i) {
        x[i] = 1 + (kSide - 2) * Advance(0.7548776662466927, &u_);
        y[i] = 1 + (kSide - 2) * Advance(0.5698402909980532, &v_);
      }
      return;
    }
    driven_ = driven_ < 50 ? driven_ + 0.02 : 0;
    double* ahead = where_ == kEastward ? x : y;
    double* aside = where_ == kEastward ? y : x;
    for (int i = 0; i < kWheel; ++i) {
      ahead[i] = 5 + driven_ + 0.05 * i;
      aside[i] = 20 + 0.3 * driven_;
    }
  }

 private:
  static double Advance(double step, double* value) {
    *value += step;
    if (*value >= 1) *value -= 1;
    return *value;
  }

  std::int64_t where_;
  double driven_ = 0;
  double u_ = 0;
  double v_ = 0;
};

// A drive of 50 m, 2500 times a wheel.
constexpr int kWheels = 2500;

void SetRate(benchmark::State& state, int queries) {
  state.SetItemsProcessed(state.iterations() * queries);
  state.counters["ns"] = benchmark::Counter(
      1e-9 * queries, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// Calls `heights(count, x, y, z)` for each wheel: one query for a height, three for a normal too.
template <typename Heights>
void AskForHeights(benchmark::State& state, bool with_normal, Heights heights) {
  Places places(state.range(1));
  double x[3 * kWheel];
  double y[3 * kWheel];
  double z[3 * kWheel];
  for ([[maybe_unused]] auto _ : state) {
    for (int wheel = 0; wheel < kWheels; ++wheel) {
      places.Next(x, y);
      for (int i = 0; with_normal && i < kWheel; ++i) {
        x[kWheel + i] = x[i] + 0.1;
        y[kWheel + i] = y[i];
        x[2 * kWheel + i] = x[i];
        y[2 * kWheel + i] = y[i] + 0.1;
      }
      heights(with_normal ? 3 * kWheel : kWheel, x, y, z);
      benchmark::DoNotOptimize(z);
    }
  }
  SetRate(state, kWheels * kWheel);
}

void AskRaster(benchmark::State& state, bool with_normal) {
  const HeightMap map = MakeRaster(1e-3 * static_cast<double>(state.range(0)));
  AskForHeights(state, with_normal, [&map](int count, const double* x, const double* y, double* z) {
    map.Heights(count, x, y, z);
  });
}

void AskTin(benchmark::State& state, bool with_normal) {
  const TinSurface tin = MakeTin(1e-3 * static_cast<double>(state.range(0)));
  AskForHeights(state, with_normal, [&tin](int count, const double* x, const double* y, double* z) {
    for (int i = 0; i < count; ++i) tin.FindHeight(x[i], y[i], &z[i]);
  });
}

// Arguments: cell size [mm], Where.
void RasterHeights(benchmark::State& state) { AskRaster(state, false); }
BENCHMARK(RasterHeights)
    ->ArgsProduct({{1000, 100, 20}, {kEastward, kNorthward, kScattered}})
    ->ArgNames({"mm", "where"});

void RasterHeightAndNormal(benchmark::State& state) { AskRaster(state, true); }
BENCHMARK(RasterHeightAndNormal)
    ->ArgsProduct({{1000, 100, 20}, {kEastward, kNorthward, kScattered}})
    ->ArgNames({"mm", "where"});

// The argument is the triangles' width [mm].
void TinHeights(benchmark::State& state) { AskTin(state, false); }
BENCHMARK(TinHeights)
    ->ArgsProduct({{1000, 100}, {kEastward, kNorthward, kScattered}})
    ->ArgNames({"mm", "where"});

void TinHeightAndNormal(benchmark::State& state) { AskTin(state, true); }
BENCHMARK(TinHeightAndNormal)
    ->ArgsProduct({{1000, 100}, {kEastward, kNorthward, kScattered}})
    ->ArgNames({"mm", "where"});

// Branches over one cell in a hundred, which the vehicle passes under.
ObstacleMap MakeBranches(double cell) {
  const int cells = static_cast<int>(kSide / cell);
  const HeightMap::Grid grid{cells, cells, {0, 0}, {cell, cell}};
  std::mt19937 random(1);
  std::vector<float> lowest(grid.CellCount(), std::numeric_limits<float>::infinity());
  for (float& height : lowest) {
    if (random() % 100 == 0) height = 2.5F;
  }
  return ObstacleMap(grid, std::move(lowest));
}

// A vehicle's box, 4 m x 2 m.
void ClearanceOfABox(benchmark::State& state) {
  const ObstacleMap map = MakeBranches(1e-3 * static_cast<double>(state.range(0)));
  Places places(state.range(1));
  double x[kWheel];
  double y[kWheel];
  for ([[maybe_unused]] auto _ : state) {
    for (int wheel = 0; wheel < kWheels; ++wheel) {
      places.Next(x, y);
      benchmark::DoNotOptimize(map.BlocksBox({x[0], y[0]}, 0.3, {2, 1}, 2.0));
    }
  }
  SetRate(state, kWheels);
}
BENCHMARK(ClearanceOfABox)
    ->ArgsProduct({{500, 200}, {kEastward, kNorthward, kScattered}})
    ->ArgNames({"mm", "where"});

// The ground of a drive: a raster (cell size [mm]) or a TIN (negative: its triangles' width), with
// obstacles to pass under (cell size [mm]) or without (0).
Terrain MakeDriveTerrain(std::int64_t millimetres, std::int64_t obstacles_millimetres) {
  const double size = 1e-3 * static_cast<double>(std::abs(millimetres));
  const double obstacles = 1e-3 * static_cast<double>(obstacles_millimetres);
  Terrain terrain(LocalFrame("", Eigen::Vector2d::Zero()), MakeRaster(millimetres > 0 ? size : 0.5),
                  MaterialMap(Material()), obstacles > 0 ? MakeBranches(obstacles) : ObstacleMap());
  if (millimetres < 0) terrain.set_tin(std::make_shared<const TinSurface>(MakeTin(size)));
  return terrain;
}

// A vehicle driven across. The rate is simulated seconds per second: the real-time factor.
void Rollout(benchmark::State& state) {
  const Terrain terrain = MakeDriveTerrain(state.range(0), state.range(1));
  const auto vehicle = LoadVehicle("tomcar-tm27");
  const Path path({{8, 8}, {50, 50}});
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    simulated +=
        DrivePath(terrain, *vehicle, path, path.Position(0), path.VehicleHeading(0), {}).time;
  }
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
BENCHMARK(Rollout)
    ->ArgsProduct({{1000, 100, 20, -1000, -100}, {0}})
    ->ArgsProduct({{1000}, {500, 200}})
    ->ArgNames({"mm", "obstacles_mm"});

// 32 vehicles across, in the processor's widest lanes, on one thread.
void RolloutsInLanes(benchmark::State& state) {
  const Terrain terrain = MakeDriveTerrain(state.range(0), 0);
  const auto vehicle = LoadVehicle("tomcar-tm27");
  std::vector<Candidate> candidates;
  for (int i = 0; i < 32; ++i) {
    candidates.emplace_back();
    candidates.back().path = Path({{8 + 0.2 * i, 8}, {50 + 0.2 * i, 50}});
  }
  PlanOptions options;
  options.threads = 1;
  double simulated = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const auto& rollout : EvaluateRollouts(terrain, *vehicle, candidates, options, {}, {})) {
      simulated += rollout.time;
    }
  }
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
BENCHMARK(RolloutsInLanes)->Arg(1000)->Arg(100)->Arg(-1000)->Arg(-100)->ArgName("mm");

}  // namespace
}  // namespace dbd

BENCHMARK_MAIN();
