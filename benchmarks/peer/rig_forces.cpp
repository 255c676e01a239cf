#include "rig_forces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dbd {

using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

double DeepestPointTireForce(const Ground& ground, const TireModel& tire, const Vec3& p,
                             const Vec3& v) {
  constexpr int kPoints = 121;
  const double radius = tire.radius;
  std::array<double, kPoints> x, y, height;
  for (int i = 0; i < kPoints; ++i) {
    x[i] = p[0] + radius * 0.9 * (i / 60.0 - 1);
    y[i] = p[1];
  }
  ground.Heights(kPoints, x.data(), y.data(), height.data());
  double deepest = 0, slope = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double ahead = x[i] - p[0];
    const double below = std::sqrt(radius * radius - ahead * ahead);
    const double depth = height[i] - p[2] + below;
    if (depth > deepest) deepest = depth, slope = ahead / below;
  }
  if (deepest == 0) return 0;
  return std::max(0.0, tire.stiffness * deepest + tire.damping * (v[0] * slope - v[2]));
}

/// A spring between its mounts: direction from the upper to the lower one, and its push.
struct RigForces::Strut {
  Vec3 direction;
  double push;
};

RigForces::RigForces(const VehicleModel& vehicle, const Ground& ground, const GuideForces& guide,
                     std::vector<MobilizedBody> bodies)
    : vehicle_(vehicle), ground_(ground), guide_(guide), bodies_(std::move(bodies)) {}

RigForces::Strut RigForces::StrutOf(const State& state, const SpringModel& spring) const {
  const MobilizedBody& a = bodies_[spring.body_a];
  const MobilizedBody& b = bodies_[spring.body_b];
  Vec3 top, top_rate, pivot, pivot_rate, ball, ball_rate;
  a.findStationLocationAndVelocityInGround(state, ToSimbody(spring.p_A), top, top_rate);
  a.findStationLocationAndVelocityInGround(state, ToSimbody(spring.p_Q), pivot, pivot_rate);
  b.findStationLocationAndVelocityInGround(state, ToSimbody(spring.p_B), ball, ball_rate);
  const Vec3 d = pivot + spring.lever * (ball - pivot) - top;
  const Vec3 rate = pivot_rate + spring.lever * (ball_rate - pivot_rate) - top_rate;
  const double length = d.norm();
  const Vec3 direction = d / length;
  return {direction, spring.stiffness * (spring.free_length - length) -
                         spring.damping * SimTK::dot(rate, direction)};
}

double RigForces::SpringForce(const State& state, std::size_t index) const {
  return StrutOf(state, vehicle_.springs[index]).push;
}

double RigForces::TireForce(const State& state, std::size_t index) const {
  const WheelModel& wheel = vehicle_.wheels[index];
  Vec3 p, v;
  bodies_[wheel.body].findStationLocationAndVelocityInGround(state, ToSimbody(wheel.p_BH), p, v);
  return DeepestPointTireForce(ground_, wheel.tire, p, v);
}

void RigForces::AddSpring(const State& state, std::size_t index,
                          SimTK::Vector_<SpatialVec>& body_forces) const {
  const SpringModel& spring = vehicle_.springs[index];
  const Strut strut = StrutOf(state, spring);
  const Vec3 force = strut.push * strut.direction;
  const MobilizedBody& a = bodies_[spring.body_a];
  const MobilizedBody& b = bodies_[spring.body_b];
  a.applyForceToBodyPoint(state, ToSimbody(spring.p_A), -force, body_forces);
  a.applyForceToBodyPoint(state, ToSimbody(spring.p_Q), (1 - spring.lever) * force, body_forces);
  b.applyForceToBodyPoint(state, ToSimbody(spring.p_B), spring.lever * force, body_forces);
}

void RigForces::AddGuide(const State& state, SimTK::Vector_<SpatialVec>& body_forces) const {
  const MobilizedBody& chassis = bodies_[0];
  const Vec3& p = chassis.getBodyOriginLocation(state);
  const Vec3& v = chassis.getBodyOriginVelocity(state);
  const Vec3 forward = chassis.getBodyRotation(state).x();
  const double yaw = std::atan2(forward[1], forward[0]);
  const double since = std::max(0.0, state.getTime() - guide_.standing_time);
  const double wanted = std::min(guide_.acceleration * since, guide_.target_speed);
  const Vec3 force(guide_.speed_gain * (wanted - v[0]),
                   -guide_.side_stiffness * p[1] - guide_.side_damping * v[1], 0);
  const double yaw_rate = chassis.getBodyAngularVelocity(state)[2];
  const Vec3 torque(0, 0, -guide_.side_stiffness * yaw - guide_.side_damping * yaw_rate);
  chassis.applyBodyForce(state, SpatialVec(torque, force), body_forces);
}

void RigForces::calcForce(const State& state, SimTK::Vector_<SpatialVec>& body_forces,
                          SimTK::Vector_<Vec3>&, SimTK::Vector&) const {
  for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) AddSpring(state, i, body_forces);
  for (std::size_t i = 0; i < vehicle_.wheels.size(); ++i) {
    const WheelModel& wheel = vehicle_.wheels[i];
    bodies_[wheel.body].applyForceToBodyPoint(state, ToSimbody(wheel.p_BH),
                                              Vec3(0, 0, TireForce(state, i)), body_forces);
  }
  AddGuide(state, body_forces);
}

SimTK::Real RigForces::calcPotentialEnergy(const State&) const { return 0; }

}  // namespace dbd
