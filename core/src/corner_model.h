#pragma once

#include "corners.h"
#include "engine_model.h"
#include "pack.h"
#include "vec.h"

namespace dbd {

// The numbers of a vehicle in lanes: the engine's templates find the same fields as in a
// VehicleModel, with a number for each lane in the place of one for all. Where a lane has no
// element, it has one that does nothing: without stiffness, or out of reach of the ground.

/// Principal moments of inertia, in every lane.
template <class Real>
struct CornerInertia {
  Vec3<Real> moments;
  bool spherical = false;  // in all lanes

  const Real& x() const { return moments.x; }
  const Real& y() const { return moments.y; }
  const Real& z() const { return moments.z; }
};

template <class Real>
bool IsSpherical(const CornerInertia<Real>& inertia) {
  return inertia.spherical;
}

template <class Real>
struct CornerBody {
  Real mass;
  CornerInertia<Real> inertia;
};

template <class Real>
struct CornerLink {
  int body_a, body_b, steered_wheel;
  Vec3<Real> p_A, p_B;
  Real stiffness, damping, free_length, steer_linear, steer_quadratic;
};

template <class Real>
struct CornerCurve {
  struct Hinge {
    Real at, slope_change;
  };
  Real origin, value, slope;
  std::vector<Hinge> hinges;
  bool is_given = false;

  bool given() const { return is_given; }
};

template <class Real>
struct CornerStop {
  Real stiffness, growth, damping, shortest_length, longest_length;
};

template <class Real>
const Real& StiffnessGrowth(const CornerStop<Real>& stop) {
  return stop.growth;
}

template <class Real>
struct CornerSpring {
  int body_a, body_b;
  Vec3<Real> p_A, p_Q, p_B;
  Real lever, stiffness, damping, free_length;
  CornerCurve<Real> force_curve, damping_curve;
  CornerStop<Real> bump_stop;
  bool has_stops = false;
};

template <class Real>
bool HasStops(const CornerSpring<Real>& spring) {
  return spring.has_stops;
}

template <class Real>
struct CornerJoint {
  int body_a, body_b, steered_wheel;
  Vec3<Real> axis_a, axis_b;
  Real stiffness, damping, rest;
};

template <class Real>
struct CornerContact {
  int body;
  Vec3<Real> p_B;
  Real stiffness, damping, friction, tangential_stiffness, tangential_damping;
};

template <class Real>
struct CornerFriction {
  FrictionModel::Motion motion;
  int body_a, body_b;
  Vec3<Real> axis_a, p_B;
  Real limit, stiffness, damping;
};

template <class Real>
struct CornerLoad {
  int body;
  Vec3<Real> p_B, force, torque;
  bool turns_with_body;
};

template <class Real>
struct CornerWheel {
  int body, reaction_body;
  Vec3<Real> p_BH;
  bool steers_hub;
  Real spin_inertia, gyroscopic_inertia;
};

template <class Real>
struct CornerVehicle {
  std::vector<CornerBody<Real>> bodies;
  std::vector<CornerLink<Real>> links;
  std::vector<CornerSpring<Real>> springs;
  std::vector<CornerJoint<Real>> joints;
  std::vector<CornerContact<Real>> contacts;
  std::vector<CornerFriction<Real>> frictions;
  std::vector<CornerLoad<Real>> loads;
  std::vector<CornerWheel<Real>> wheels;
};

}  // namespace dbd
