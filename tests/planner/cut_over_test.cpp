#include "cut_over.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

struct Outcome {
  double seconds = 0;
  std::int64_t serial_rounds = 0;
  std::int64_t parallel_rounds = 0;
};

/// Lets `cut_over` choose for many rounds of constant cost.
Outcome Play(CutOver& cut_over, double serial_cost, double parallel_cost, std::int64_t rounds) {
  Outcome outcome;
  for (std::int64_t done = 0; done < rounds;) {
    const CutOver::Plan plan = cut_over.Next(rounds - done);
    const double seconds =
        static_cast<double>(plan.rounds) * (plan.parallel ? parallel_cost : serial_cost);
    cut_over.Report(plan, seconds);
    outcome.seconds += seconds;
    (plan.parallel ? outcome.parallel_rounds : outcome.serial_rounds) += plan.rounds;
    done += plan.rounds;
  }
  return outcome;
}

constexpr std::int64_t kRounds = 500'000;

TEST(CutOver, SharesWhatGainsByIt) {
  CutOver cut_over;
  const Outcome outcome = Play(cut_over, 10e-6, 6e-6, kRounds);
  EXPECT_GT(outcome.parallel_rounds, 0.98 * kRounds);
}

TEST(CutOver, LosingWayCostsLessThanTwoPercent) {
  CutOver cut_over;
  const Outcome outcome = Play(cut_over, 10e-6, 20e-6, kRounds);
  EXPECT_LT(outcome.seconds, 1.02 * 10e-6 * kRounds);
  EXPECT_GT(outcome.parallel_rounds, 0);  // it has tried
}

TEST(CutOver, NoticesThatTheMachineHasBecomeFree) {
  CutOver cut_over;
  Play(cut_over, 10e-6, 30e-6, kRounds);
  const Outcome later = Play(cut_over, 10e-6, 5.5e-6, kRounds);
  EXPECT_GT(later.parallel_rounds, 0.8 * kRounds);
}

TEST(CutOver, EqualSpeedStaysWithOneThread) {
  CutOver cut_over;
  const Outcome outcome = Play(cut_over, 10e-6, 9.9e-6, kRounds);
  EXPECT_GT(outcome.serial_rounds, 0.9 * kRounds);
}

TEST(CutOver, ShortRunsAreCountedTogether) {
  CutOver cut_over;
  std::int64_t shared = 0;
  for (int run = 0; run < 10'000; ++run) shared += Play(cut_over, 10e-6, 6e-6, 10).parallel_rounds;
  EXPECT_GT(shared, 90'000);
}

}  // namespace
}  // namespace dbd
