#pragma once

#include <dbd/core/simulation.h>
#include <dbd/core/sinkage.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <array>

#include "deepest_sinkage.h"

namespace dbd {

/// What the judge looks at: the trace's row, and facts that need no row.
struct Observation {
  TraceSample sample;
  bool on_known_ground = true;
  const Material* impassable = nullptr;  ///< the material under a wheel that must not be driven on
  bool hits_obstacle = false;
  double up = 1;  ///< cosine of the chassis' tilt
};

/// Looks at a vehicle of one kind on one terrain, many times in a drive: what only these two
/// determine is found once.
class Observer {
 public:
  /// Both must outlive it.
  Observer(const Terrain& terrain, const VehicleModel& vehicle, const SinkageOptions& sinkage = {});

  Observation Observe(const VehicleSnapshot& snapshot) const;

 private:
  using Wheels = std::vector<WheelView>;

  double GroundSlope(const Wheels& wheels) const;
  double BellyClearance(const ChassisView& chassis) const;
  double LoadTransferRatio(const Wheels& wheels) const;
  void AddDrivenWheels(const Wheels& wheels, TraceSample& sample) const;
  bool AllOnKnownGround(const Wheels& wheels) const;
  void LookAtGround(double yaw, const Wheels& wheels, Observation& observation) const;
  bool HitsObstacle(const ChassisView& chassis) const;

  static constexpr std::size_t kBellyPoints = 15;

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  DeepestSinkage sinkage_;
  std::array<Eigen::Vector3d, kBellyPoints> belly_B_;
  double weight_;          // [N]
  double print_reach_;     // of the widest tire's print from its hub, at most [m]
  const AxleModel* rear_;  // rearmost
  const AxleModel* foremost_;
};

}  // namespace dbd
