#pragma once

#include <dbd/core/units.h>
#include <dbd/core/vehicle_model.h>

#include <cstdint>
#include <vector>

#include "joined_bodies.h"
#include "tire_numbers.h"
#include "tire_pattern.h"

namespace dbd {

/// A stiff link stretched by more than this has torn a body off [m].
inline constexpr double kTornLink = 0.2;

/// Largest torque that a differential moves across [N m].
double CouplingTorque(const DifferentialModel& differential);

/// What is constant for one vehicle and one choice of steps.
struct EngineModel {
  /// `vehicle_model` must outlive it.
  explicit EngineModel(const VehicleModel& vehicle_model);
  ~EngineModel();  // in a translation unit for any processor

  const VehicleModel* vehicle;
  JoinedBodies joined;
  std::vector<TirePattern> patterns;       ///< like vehicle->wheels
  std::vector<TireNumbers<double>> tires;  ///< like vehicle->wheels
  std::vector<double> carrier_inertia;  ///< about the spin axis, of each wheel's share of its body
  std::vector<double> axle_coupling;    ///< like vehicle->axles: differential's most [N m]
  std::vector<int> driven_wheels;
  std::vector<double> torn_force;  ///< like vehicle->links: pull or push that tears it off [N]
  double centre_coupling = 0;      ///< of the differential between axles [N m]
  double gravity = kGravity;
  double step;
  int spring_every = 1;  ///< construction steps per update of the group
  int tire_every = 1;
  int control_every = 1;
  int period = 1;  ///< steps after which all groups begin together again

  /// Whether any differential moves torque across.
  bool CouplesShafts() const;
  /// Steps of settling for at least `time` [s], in whole periods.
  std::int64_t SettlingSteps(double time) const;
};

}  // namespace dbd
