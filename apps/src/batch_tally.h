#pragma once

#include <dbd/planner/planning_service.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "console.h"

namespace dbd {

/// Counts what a batch has answered, for its progress line and its summary.
class BatchTally {
 public:
  /// `what` is answered: "requests".
  explicit BatchTally(std::string what) : what_(std::move(what)) {}

  void Add(const JobResult& result);
  /// What was answered without a plan.
  void Add(const std::string& status) { ++counts_[status]; }

  std::size_t answered() const;
  std::size_t errors() const;

  /// With rate and time left, of `total` that are known so far.
  void Show(std::size_t total, ProgressLine& line) const;

  /// For people; `skipped`: answered by an earlier run.
  std::string Summary(std::size_t skipped) const;

 private:
  double Seconds() const;

  const std::string what_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::map<std::string, std::size_t> counts_;
  std::size_t rollouts_ = 0;
  double simulated_ = 0;  // [s]
};

}  // namespace dbd
