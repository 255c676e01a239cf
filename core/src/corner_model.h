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
struct CornerBrixius {
  Real traction_max, mobility_rate, slip_rate, carcass_loss, resistance_mobility, resistance_slip;
};

template <class Real>
struct CornerTire {
  Real radius, width, section_height, stiffness, damping;
  Real lateral_limit, lateral_rate, relaxation_length;
  CornerBrixius<Real> traction;
};

template <class Real>
struct CornerWheel {
  int body, reaction_body;
  Vec3<Real> p_BH;
  bool steers_hub;
  Real spin_inertia, gyroscopic_inertia;
  CornerTire<Real> tire;
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

/// TirePattern in lanes; all tires have the same number of points.
template <class Real>
struct CornerPattern {
  using Row = std::array<Real, kMaxLowerPoints>;
  Real radius, half_span, width, stiffness;
  double reach = 0;  // of all lanes
  int count = 0;
  Row x, z, bulge, half_by_bulge, length, by_length;
};

/// AttachmentPoints in lanes.
template <class Real>
struct CornerPoints {
  struct Point {
    int body;
    Vec3<Real> p_B;
  };

  const std::vector<Point>& points() const { return all; }
  const std::vector<std::size_t>& first() const { return first_of_body; }
  const std::vector<AttachmentPoints::LinkEnds>& links() const { return link_ends; }
  const std::vector<AttachmentPoints::SpringEnds>& springs() const { return spring_ends; }

  std::vector<Point> all;  // sorted by body
  std::vector<std::size_t> first_of_body;
  std::vector<AttachmentPoints::LinkEnds> link_ends;
  std::vector<AttachmentPoints::SpringEnds> spring_ends;
};

}  // namespace dbd
