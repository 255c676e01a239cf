#pragma once

#include <dbd/core/driver_care.h>
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

/// Looks at one drive of a vehicle on a terrain, many times: what only these two determine is found
/// once.
class Observer {
 public:
  /// Both must outlive it.
  Observer(const Terrain& terrain, const VehicleModel& vehicle, const SinkageOptions& sinkage = {});

  /// All but sinkage and slope.
  Observation Observe(const VehicleSnapshot& snapshot);

  /// Adds sinkage and slope as of the last look, which was at these wheels.
  void AddSinkageAndSlope(const std::vector<WheelView>& wheels, TraceSample& sample);

  /// The same for a look of which no row is kept. What is neither worse than all before nor so bad
  /// that a driver takes care stays as it was at an earlier such look.
  void AddSinkageAndSlopeIfWorse(const std::vector<WheelView>& wheels, TraceSample& sample);

 private:
  using Wheels = std::vector<WheelView>;

  /// Rise over run of the ground, both squared.
  struct Grade {
    double rise = 0;
    double run = 1;

    bool IsWithin(const Grade& other) const { return rise * other.run <= other.rise * run; }
  };

  void LookAtHeights(const VehicleSnapshot& snapshot, TraceSample& sample);
  void AddSinkage(const Wheels& wheels, TraceSample& sample);
  void AddSlope(TraceSample& sample);
  double LoadTransferRatio(const Wheels& wheels) const;
  void AddDrivenWheels(const Wheels& wheels, TraceSample& sample) const;
  bool AllOnKnownGround(const Wheels& wheels) const;
  void LookAtGround(double yaw, const Wheels& wheels, Observation& observation) const;
  bool HitsObstacle(const ChassisView& chassis) const;

  static constexpr std::size_t kBellyPoints = 15, kCorners = 4;

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  double negligible_sinkage_;  // up to which no driver takes care [m]
  DeepestSinkage sinkage_;
  std::array<Eigen::Vector3d, kBellyPoints> belly_B_;
  double weight_;          // [N]
  double print_reach_;     // of the widest tire's print from its hub, at most [m]
  const AxleModel* rear_;  // rearmost
  const AxleModel* foremost_;
  double negligible_slope_;  // up to which no driver takes care [rad]
  Grade grade_;              // of the last look
  // Of the looks at which they were negligible: the last values, and the steepest grade.
  double last_sinkage_ = 0;
  double last_slope_ = 0;
  Grade steepest_;
};

}  // namespace dbd
