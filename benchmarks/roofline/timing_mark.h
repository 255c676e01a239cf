#pragma once

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <cstdint>

#include "machine_peaks.h"
#include "stages.h"

namespace dbd {

/// Sums the processor's ticks by stage.
class TimingMark {
 public:
  void Begin() { last_ = Ticks(); }
  void operator()(Stage stage) {
    const std::uint64_t now = Ticks();
    ticks_[static_cast<std::size_t>(stage)] += static_cast<double>(now - last_);
    last_ = now;
  }

  std::array<double, kStages> Shares() const {
    double sum = 0;
    for (const double ticks : ticks_) sum += ticks;
    std::array<double, kStages> shares = ticks_;
    for (double& share : shares) share /= sum;
    return shares;
  }

 private:
  static std::uint64_t Ticks() {
#ifdef __x86_64__
    return __rdtsc();
#else
    return static_cast<std::uint64_t>(1e9 * ThreadSeconds());
#endif
  }

  std::uint64_t last_ = 0;
  std::array<double, kStages> ticks_{};
};

}  // namespace dbd
