#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace dbd {

/// Asks for a stop when its time is up or when its owner's token does, whichever comes first: who
/// works under a deadline needs to look at one token only.
class Deadline {
 public:
  /// `seconds` from now; infinite = no limit.
  Deadline(double seconds, const std::stop_token& owner);

  std::stop_token token() const { return stop_.get_token(); }

  /// Whether time ran out, and not the owner's patience.
  bool passed() const { return passed_; }

 private:
  struct Forward {
    std::stop_source stop;
    void operator()() { stop.request_stop(); }
  };

  void Watch(const std::stop_token& done, double seconds);

  std::stop_source stop_;
  std::atomic<bool> passed_ = false;
  std::stop_callback<Forward> forward_;
  std::jthread watch_;
};

}  // namespace dbd
