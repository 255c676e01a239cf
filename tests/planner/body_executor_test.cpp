#include <dbd/planner/body_executor.h>

#include <dbd/core/scenario.h>
#include <dbd/core/scene.h>
#include <dbd/core/vehicle_database.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <stdexcept>

namespace dbd {
namespace {

/// Twelve cars close behind each other on rough ground, some of which push.
std::uint64_t DriveColumn(LockstepExecutor& executor) {
  const auto car = LoadVehicle("tomcar-tm27");
  const auto ground = MakeRandomGround(-60, 0.1, 0.5, 7);
  std::vector<SceneVehicle> vehicles;
  for (int i = 0; i < 12; ++i) {
    vehicles.push_back({.model = car, .position = {-3.0 * i, 0.05 * (i % 3)}, .ahead = i - 1});
    vehicles.back().command.engine_torque = 10.0 * i;
  }
  Scene scene(vehicles, *ground, {.settle_time = 0.2});
  double pressed = 0;
  for (int i = 0; i < 10; ++i) {
    scene.Advance(0.05, executor);
    for (int v = 1; v < 12; ++v) pressed = std::max(pressed, scene.BumperForce(v));
  }
  EXPECT_GT(pressed, 100);
  return scene.StateHash();
}

TEST(BodyExecutor, SceneIsBitIdenticalForAnyNumberOfThreads) {
  SerialExecutor serial;
  const std::uint64_t expected = DriveColumn(serial);
  // Three threads even where there are fewer processors.
  const tbb::global_control three(tbb::global_control::max_allowed_parallelism, 3);
  for (const int threads : {1, 2, 3}) {
    for (const bool adapt : {false, true}) {
      BodyExecutor executor({.threads = threads, .adapt = adapt});
      EXPECT_EQ(executor.worker_count(), threads);
      EXPECT_EQ(DriveColumn(executor), expected) << threads << " threads, adapt " << adapt;
    }
  }
}

TEST(BodyExecutor, SharesOnlyWhatIsLargeEnough) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  BodyExecutor executor({.threads = 2, .least_items = 8, .adapt = false});
  const RoundFunction nothing = [](int, std::int64_t, int, int) {};
  executor.Run(100, 7, nothing);
  EXPECT_EQ(executor.parallel_share(), 0);
  executor.Run(100, 8, nothing);
  EXPECT_EQ(executor.parallel_share(), 0.5);
}

TEST(BodyExecutor, WorksWhereNoSecondThreadIsGranted) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  BodyExecutor executor({.threads = 2, .adapt = false});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  std::int64_t items = 0;
  executor.Run(50, 20, [&](int, std::int64_t, int begin, int end) { items += end - begin; });
  EXPECT_EQ(items, 50 * 20);
}

TEST(BodyExecutor, RoundsAreNumberedThroughARunAlsoWhenItAdapts) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  BodyExecutor executor({.threads = 2});
  std::vector<int> counts(3000, 0);
  executor.Run(3000, 16, [&](int, std::int64_t round, int begin, int) {
    if (begin == 0) ++counts[static_cast<std::size_t>(round)];
  });
  EXPECT_EQ(counts, std::vector<int>(3000, 1));
}

TEST(BodyExecutor, ExceptionsReachTheCaller) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  BodyExecutor executor({.threads = 2, .adapt = false});
  const RoundFunction fails = [](int, std::int64_t round, int, int) {
    if (round == 3) throw std::runtime_error("broken");
  };
  EXPECT_THROW(executor.Run(10, 20, fails), std::runtime_error);
}

}  // namespace
}  // namespace dbd
