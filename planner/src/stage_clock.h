#pragma once

#include <dbd/planner/plan_types.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace dbd {

inline double SecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Seconds since the last call, added up under the name of the stage that they were spent in.
class StageClock {
 public:
  explicit StageClock(Plan& plan) : plan_(plan), last_(Clock::now()) {}

  void Finish(const std::string& stage) {
    const auto entry = std::find_if(plan_.timing.begin(), plan_.timing.end(),
                                    [&](const auto& e) { return e.first == stage; });
    if (entry != plan_.timing.end()) {
      entry->second += SecondsSince(last_);
    } else {
      plan_.timing.emplace_back(stage, SecondsSince(last_));
    }
    last_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Plan& plan_;
  Clock::time_point last_;
};

}  // namespace dbd
