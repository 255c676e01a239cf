#pragma once

#include <time.h>

#include <cstddef>

namespace dbd {

/// What this processor reaches with one lane type, per second of one thread, measured. Numbers
/// count lanes: an instruction on 16 floats is 16.
struct MachinePeaks {
  double simple = 0;        ///< additions and multiplications, mixed
  double fused = 0;         ///< fused multiply-adds; 0: the instruction set has none
  double divide = 0;        ///< while nothing else runs
  double square_root = 0;   ///< likewise
  double loads = 0;         ///< instructions that load a whole pack from the first-level cache
  double memory_bytes = 0;  ///< read from main memory, one after the other
};

/// Of two measurements.
inline MachinePeaks Mean(const MachinePeaks& a, const MachinePeaks& b) {
  return {0.5 * (a.simple + b.simple), 0.5 * (a.fused + b.fused),
          0.5 * (a.divide + b.divide), 0.5 * (a.square_root + b.square_root),
          0.5 * (a.loads + b.loads),   0.5 * (a.memory_bytes + b.memory_bytes)};
}

/// CPU time of this thread [s].
inline double ThreadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Memory that may be read, at the beginning of a cache line; it is made once, and written.
const char* ReadableBytes(std::size_t count);

}  // namespace dbd
