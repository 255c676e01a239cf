#pragma once

#include <dbd/core/simulation.h>
#include <dbd/core/sinkage.h>
#include <dbd/terrain/terrain.h>

#include <array>
#include <cstddef>
#include <vector>

namespace dbd {

/// How deep the wheel sinks that sinks deepest: the largest `WheelSinkage` of a vehicle's wheels.
/// Made once per drive, asked at every look.
class DeepestSinkage {
 public:
  /// Both must outlive it. `negligible`: what is no deeper need not always be known [m].
  DeepestSinkage(const Terrain& terrain, const VehicleModel& vehicle, const SinkageOptions& options,
                 double negligible = 0);

  double Of(const std::vector<WheelView>& wheels);

  /// Whether `Of` surely gives no more than it has given before, and that is negligible. Takes no
  /// root or exponential, and denies what only these would tell.
  bool IsNegligible(const std::vector<WheelView>& wheels) const;

 private:
  static constexpr std::size_t kMostWheels = 16;
  /// What sinkage follows: it grows as the first falls and as the second grows.
  struct Severity {
    std::array<double, kMostWheels> numeric;   // N of each wheel
    std::array<double, kMostWheels> slipping;  // |slip| / N^5; negative in the air
    std::array<double, kMostWheels> least;     // numeric, by tire
    std::array<double, kMostWheels> most;      // slipping, by tire
  };

  Severity SeverityOf(const std::vector<WheelView>& wheels) const;
  double OfAll(const std::vector<WheelView>& wheels) const;
  double OfWorst(const std::vector<WheelView>& wheels);

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  SinkageOptions options_;
  std::vector<int> pass_;                // which wheel of its track each is, counted from the front
  std::vector<std::size_t> first_like_;  // the first wheel with the same tire
  bool monotonic_;                       // only relations that are, in load and slip
  double negligible_;
  // By tire, of all looks at which sinkage was negligible: none of these gives more.
  std::array<double, kMostWheels> least_numeric_, most_slipping_;
};

}  // namespace dbd
