#include "lockstep_team.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace dbd {
namespace {

/// Every item takes the sum of its neighbours of the round before, as a scene does with what the
/// vehicles published: a round that began too early, or a range done twice, changes the result.
class Neighbours {
 public:
  explicit Neighbours(int items) : values_{std::vector<std::uint64_t>(items, 1), {}} {
    values_[1] = values_[0];
    for (std::size_t i = 0; i < values_[0].size(); ++i) values_[0][i] = i + 1;
  }

  RoundFunction Function() {
    return [this](int, std::int64_t round, int begin, int end) {
      const auto& from = values_[round % 2];
      auto& to = values_[(round + 1) % 2];
      const int count = static_cast<int>(from.size());
      for (int i = begin; i < end; ++i) {
        to[i] = 3 * from[i] + from[(i + 1) % count] + from[(i + count - 1) % count];
      }
    };
  }

  const std::vector<std::uint64_t>& After(std::int64_t rounds) const { return values_[rounds % 2]; }

 private:
  std::vector<std::uint64_t> values_[2];
};

std::vector<std::uint64_t> Serial(int items, std::int64_t rounds) {
  Neighbours neighbours(items);
  SerialExecutor().Run(rounds, items, neighbours.Function());
  return neighbours.After(rounds);
}

TEST(LockstepTeam, AnyNumberOfThreadsGivesTheSerialResult) {
  constexpr int kRounds = 301;
  for (const int items : {1, 2, 7, 64}) {
    for (const int threads : {1, 2, 3}) {
      Neighbours neighbours(items);
      const RoundFunction function = neighbours.Function();
      LockstepTeam team(threads, kRounds, items, function);
      std::vector<std::thread> others;
      for (int i = 1; i < threads; ++i) others.emplace_back([&team, i] { team.Work(i); });
      team.Work(0);
      for (std::thread& other : others) other.join();
      EXPECT_EQ(neighbours.After(kRounds), Serial(items, kRounds)) << items << " " << threads;
    }
  }
}

TEST(LockstepTeam, OneWorkerFinishesWhatWasDividedAmongThree) {
  constexpr int kRounds = 20;
  Neighbours neighbours(10);
  const RoundFunction function = neighbours.Function();
  LockstepTeam team(3, kRounds, 10, function);
  team.Work(1);
  EXPECT_EQ(neighbours.After(kRounds), Serial(10, kRounds));
  team.Work(0);  // comes too late: nothing is left, and it returns
  EXPECT_EQ(neighbours.After(kRounds), Serial(10, kRounds));
}

TEST(LockstepTeam, LateWorkerJoinsInTheMiddle) {
  constexpr int kRounds = 2000;
  Neighbours neighbours(16);
  const RoundFunction function = neighbours.Function();
  std::thread late;
  LockstepTeam* joined = nullptr;
  const RoundFunction calls_for_help = [&](int worker, std::int64_t round, int begin, int end) {
    if (round == 100 && begin == 0) late = std::thread([&] { joined->Work(1); });
    function(worker, round, begin, end);
  };
  LockstepTeam team(2, kRounds, 16, calls_for_help);
  joined = &team;
  team.Work(0);
  late.join();
  EXPECT_EQ(neighbours.After(kRounds), Serial(16, kRounds));
}

TEST(LockstepTeam, ExceptionEndsTheRunOfAllWorkers) {
  std::atomic<std::int64_t> last{0};
  const RoundFunction function = [&](int, std::int64_t round, int begin, int) {
    last = round;
    if (round == 5 && begin == 0) throw std::runtime_error("item 0");
  };
  LockstepTeam team(2, 1000, 8, function);
  std::thread other([&team] { team.Work(1); });
  team.Work(0);
  other.join();
  EXPECT_THROW(team.Rethrow(), std::runtime_error);
  EXPECT_LE(last, 6);
}

}  // namespace
}  // namespace dbd
