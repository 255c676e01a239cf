#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/simulation.h>
#include <dbd/core/vehicle_model.h>

#include <vector>

#include "simbody_api.h"

namespace dbd {

/// All that acts on the peer's bodies but gravity and joints: suspension springs, the reference
/// trajectories' tire, and the test rig. `bodies` in the order of the vehicle's.
class RigForces : public SimTK::Force::Custom::Implementation {
 public:
  RigForces(const VehicleModel& vehicle, const Ground& ground, const GuideForces& guide,
            std::vector<SimTK::MobilizedBody> bodies);

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces,
                 SimTK::Vector& mobility_forces) const override;

  /// Energy is not asked for.
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

  /// Compression positive [N].
  double SpringForce(const SimTK::State& state, std::size_t index) const;

  /// Upward [N].
  double TireForce(const SimTK::State& state, std::size_t index) const;

 private:
  struct Strut;
  Strut StrutOf(const SimTK::State& state, const SpringModel& spring) const;
  void AddSpring(const SimTK::State& state, std::size_t index,
                 SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;
  void AddGuide(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;

  const VehicleModel& vehicle_;
  const Ground& ground_;
  GuideForces guide_;
  std::vector<SimTK::MobilizedBody> bodies_;
};

/// Force of the reference trajectories' tire on a wheel centre `p` that moves with `v`: the deepest
/// of 121 points on the lower rim of an upright disc.
double DeepestPointTireForce(const Ground& ground, const TireModel& tire, const SimTK::Vec3& p,
                             const SimTK::Vec3& v);

inline SimTK::Vec3 ToSimbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace dbd
