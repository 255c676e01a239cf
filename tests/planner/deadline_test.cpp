#include "deadline.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

namespace dbd {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kNever = std::numeric_limits<double>::infinity();

bool IsStopped(const std::stop_token& token, double within) {
  const auto give_up = Clock::now() + std::chrono::duration<double>(within);
  while (!token.stop_requested() && Clock::now() < give_up) std::this_thread::yield();
  return token.stop_requested();
}

TEST(Deadline, AsksForAStopWhenItsTimeIsUp) {
  const auto begin = Clock::now();
  const Deadline deadline(0.05, {});
  EXPECT_FALSE(deadline.token().stop_requested());
  EXPECT_TRUE(IsStopped(deadline.token(), 10));
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(50));
  EXPECT_TRUE(deadline.passed());
}

TEST(Deadline, HandsOnItsOwnersStop) {
  std::stop_source owner;
  const Deadline deadline(1000, owner.get_token());
  const Deadline without_limit(kNever, owner.get_token());
  EXPECT_FALSE(deadline.token().stop_requested());
  owner.request_stop();
  EXPECT_TRUE(deadline.token().stop_requested());
  EXPECT_TRUE(without_limit.token().stop_requested());
  EXPECT_FALSE(deadline.passed());
}

TEST(Deadline, DoesNotStopItsOwner) {
  std::stop_source owner;
  const Deadline deadline(0, owner.get_token());
  EXPECT_TRUE(IsStopped(deadline.token(), 10));
  EXPECT_FALSE(owner.stop_requested());
}

TEST(Deadline, EndsAtOnceWhenNoLongerNeeded) {
  const auto begin = Clock::now();
  { const Deadline deadline(1e300, {}); }
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace dbd
