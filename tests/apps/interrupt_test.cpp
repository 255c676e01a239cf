#include "interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace dbd {
namespace {

bool BecomesStopped(const std::stop_token& token) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!token.stop_requested() && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return token.stop_requested();
}

[[noreturn]] void StopYourself() {
  const Interrupt interrupt;
  const bool too_soon = interrupt.token().stop_requested();
  kill(getpid(), SIGINT);
  std::_Exit(!too_soon && BecomesStopped(interrupt.token()) ? 0 : 1);
}

// In a process of its own: threads that other tests have left behind would take the signal.
TEST(InterruptDeathTest, ControlCAsksForAStopAndDoesNotEndTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(StopYourself(), testing::ExitedWithCode(0), "");
}

TEST(Interrupt, LeavesTheSignalsAsTheyWere) {
  sigset_t before, after;
  pthread_sigmask(SIG_SETMASK, nullptr, &before);
  { const Interrupt interrupt; }
  pthread_sigmask(SIG_SETMASK, nullptr, &after);
  EXPECT_EQ(sigismember(&before, SIGINT), sigismember(&after, SIGINT));
}

}  // namespace
}  // namespace dbd
