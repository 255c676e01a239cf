#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/scenario.h>
#include <dbd/core/trajectory.h>
#include <dbd/core/vehicle_model.h>

#include <memory>
#include <vector>

namespace dbd {

// An equivalent vehicle in MuJoCo, for speed beside speed: an engine made for real-time control
// that robots are trained with, at its default solver and dbd's construction step.
//
// Equal: five bodies with their masses and moments of inertia; rate and damping of the suspension
// at each wheel; wheel radius, spin inertia, largest friction; the ground's heights; driver,
// powertrain, differential and brakes, which are dbd's own code; the step.
//
// Differs: wheels slide along the chassis' vertical instead of hanging on arms, the carrier spins
// with its wheel, and only the front wheels' toe is elastic. Where dbd integrates the volume under
// three planes of points and evaluates a law of the soil, here a wheel is a sphere with Coulomb
// friction on hard ground: one point or a few, no sinkage, slip law or rolling resistance. Rough
// ground is triangles instead of bilinear, and where a wheel touches several each pushes.

enum class MujocoContact {
  kTire,   ///< vertical stiffness and damping of the tire, elliptic friction cone
  kRigid,  ///< MuJoCo's defaults: nearly rigid, friction pyramid
};

class MujocoVehicle {
 public:
  /// Both must outlive it. `scenario`: A, B, C or D as `MakeScenario` gives them.
  MujocoVehicle(const Scenario& scenario, const VehicleModel& vehicle, MujocoContact contact);
  ~MujocoVehicle();

  /// Back to the beginning: at rest in the design pose, heading east at the origin.
  void Reset();

  /// Drives one control interval as `ScenarioDriver` does: standing, then straight ahead.
  void Advance();

  double time() const;
  double control_step() const;
  /// Of the ground on all wheels together, upwards [N].
  double GroundForce() const;
  TrajectoryRow Observe() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Resets and drives the whole scenario; a row per control interval.
std::vector<TrajectoryRow> RecordMujoco(const Scenario& scenario, MujocoVehicle& vehicle);

}  // namespace dbd
