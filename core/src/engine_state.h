#pragma once

#include <dbd/core/vehicle_model.h>

#include <array>
#include <cstdint>
#include <vector>

#include "vec.h"

namespace dbd {

/// Most wheels a vehicle may have: two for each of eight axles.
inline constexpr int kMaxWheels = 16;

/// Motion of one body. Positions belong to time t, velocities to t - dt/2 (leapfrog).
template <class Real>
struct BodyState {
  Vec3<Real> p_WB;
  Quat<Real> q_WB;
  Vec3<Real> v_WB;
  Vec3<Real> h_WB;  // angular momentum about Bo, in W
  Vec3<Real> w_WB;  // angular velocity that belongs to h_WB
};

/// Which traction model holds under a wheel, and what Bekker's wheel gave at sampling time.
template <class Real>
struct SoilRule {
  Real model;       // number of the TractionModel
  Real capacity;    // Bekker: thrust at full slip / load
  Real shear_rate;  // Bekker: contact length / K
  Real resistance;  // Bekker: compaction resistance / load
};

/// What the ground did to a wheel when it was last sampled (SPLIT tire: geometry is held between
/// samples, the force law is not).
template <class Real>
struct TireContact {
  Vec3<Real> normal_W;
  Vec3<Real> p_HC_W;  // hub to contact point
  Vec3<Real> p_WH;    // hub at sampling time
  Real deflection;    // at sampling time, 0 = no contact
  Real cone_index;
  Real friction_limit;
  SoilRule<Real> rule;
};

/// A wheel's own degrees of freedom, and what it last met.
template <class Real>
struct WheelState {
  Real spin;        // [rad/s], forward rolling positive
  Real slip;        // relaxed longitudinal slip [-]
  Real slip_angle;  // relaxed lateral slip, tangent [-]
  TireContact<Real> contact;
};

/// A body point's contact: the ground's tangent plane when last sampled, and the bristle.
template <class Real>
struct PointContactState {
  Vec3<Real> normal_W;
  Vec3<Real> p_WG;       // on the ground under the point
  Vec3<Real> bristle_W;  // elastic displacement along the ground [m]
};

template <class Real>
struct EngineState {
  std::vector<BodyState<Real>> bodies;
  std::vector<WheelState<Real>> wheels;
  std::vector<PointContactState<Real>> contacts;  // like model.contacts
  std::vector<Real> frictions;                    // elastic displacement [m] or [rad]
  std::int64_t step = 0;                          // construction steps since the start
};

/// What driver and powertrain ask of the wheels, held between control steps.
template <class Real>
struct WheelControls {
  std::array<Real, kMaxWheels> steer_sine{};    // of each wheel, left positive
  std::array<Real, kMaxWheels> drive_torque{};  // [N m]
  std::array<Real, kMaxWheels> brake_torque{};  // largest friction torque, positive
};

template <class Real>
struct Wrench {
  Vec3<Real> f_W;
  Vec3<Real> t_W;  // about the body's centre of mass

  void Clear() { *this = Wrench{}; }
  void Add(const Vec3<Real>& f, const Vec3<Real>& lever) {
    f_W += f;
    t_W += Cross(lever, f);
  }
};

/// A point fixed to a body: lever arm from the body's centre of mass, place and velocity, in W or
/// in the axes of the body that it is seen from.
template <class Real>
struct BodyPoint {
  Vec3<Real> lever;
  Vec3<Real> p;
  Vec3<Real> v;
};

/// Results of the tire force law that others report: per wheel, of the last step.
template <class Real>
struct TireReport {
  Real load;  // along the normal [N]
  Real slip;
  Real net_traction;  // along the heading [N]
  Real capacity;      // largest gross traction on this soil under this load [N]
  Real lateral;       // [N]
  Real deflection;
  Real drive_power;  // of the drive torque [W]
};

/// Scratch of one worker: sized once, so that a step allocates nothing.
template <class Real>
struct Workspace {
  std::vector<Mat3<Real>> R_WB;
  std::vector<Wrench<Real>> wrench;     // of this step
  std::vector<Vec3<Real>> spring_push;  // held between spring updates, in axes of their body a
  std::vector<Real> spring_force;       // compression positive [N]
  std::vector<Real> link_force;         // tension positive [N]
  std::vector<TireReport<Real>> tires;
  std::vector<Real> contact_force;   // normal [N]
  std::vector<Real> friction_force;  // [N] or [N m]

  template <class Model>
  explicit Workspace(const Model& model)
      : R_WB(model.bodies.size()),
        wrench(model.bodies.size()),
        spring_push(model.springs.size()),
        spring_force(model.springs.size()),
        link_force(model.links.size()),
        tires(model.wheels.size()),
        contact_force(model.contacts.size()),
        friction_force(model.frictions.size()) {}
};

}  // namespace dbd
