#pragma once

#include <dbd/core/simulation.h>
#include <dbd/core/sinkage.h>
#include <dbd/terrain/terrain.h>

#include <cstddef>
#include <vector>

namespace dbd {

/// How deep the wheel sinks that sinks deepest: the largest `WheelSinkage` of a vehicle's wheels.
/// Made once per drive, asked at every look.
class DeepestSinkage {
 public:
  /// Both must outlive it.
  DeepestSinkage(const Terrain& terrain, const VehicleModel& vehicle,
                 const SinkageOptions& options);

  double Of(const std::vector<WheelView>& wheels) const;

 private:
  double OfAll(const std::vector<WheelView>& wheels) const;
  double OfWorst(const std::vector<WheelView>& wheels) const;

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  SinkageOptions options_;
  std::vector<int> pass_;                // which wheel of its track each is, counted from the front
  std::vector<std::size_t> first_like_;  // the first wheel with the same tire
  bool monotonic_;                       // only relations that are, in load and slip
};

}  // namespace dbd
