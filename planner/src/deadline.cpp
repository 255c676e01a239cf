#include "deadline.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

namespace dbd {
namespace {

constexpr double kLongest = 1e8;  // [s] three years: what clocks can add without overflow

}  // namespace

Deadline::Deadline(double seconds, const std::stop_token& owner) : forward_(owner, Forward{stop_}) {
  if (std::isfinite(seconds)) {
    watch_ = std::jthread([this, seconds](const std::stop_token& done) { Watch(done, seconds); });
  }
}

void Deadline::Watch(const std::stop_token& done, double seconds) {
  const std::chrono::duration<double> left(std::min(seconds, kLongest));
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait_for(lock, done, left, [] { return false; });
  if (done.stop_requested() || stop_.stop_requested()) return;
  passed_ = true;
  stop_.request_stop();
}

}  // namespace dbd
