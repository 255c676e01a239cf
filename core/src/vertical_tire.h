#pragma once

#include <dbd/core/ground.h>

#include "engine_state.h"

namespace dbd {

// The tire of the reference trajectories: an upright disc that follows the world's x axis, touches
// the ground at its deepest of 121 points and pushes straight up at the wheel centre, spring and
// damper, never pulling. So simple that two programs can have exactly the same; for comparisons
// only.

inline constexpr int kDiscPoints = 121;
inline constexpr double kDiscSpan = 0.9;  // of the radius, to each side

/// Deepest penetration of a disc: how deep, and how far ahead of the centre.
struct DiscContact {
  double deflection = 0;
  double ahead = 0;
};

inline DiscContact FindDiscContact(const Ground& ground, double radius, double x, double y,
                                   double z) {
  double xs[kDiscPoints], ys[kDiscPoints], heights[kDiscPoints];
  const double step = 2 * kDiscSpan * radius / (kDiscPoints - 1);
  for (int i = 0; i < kDiscPoints; ++i) {
    xs[i] = x - kDiscSpan * radius + i * step;
    ys[i] = y;
  }
  ground.Heights(kDiscPoints, xs, ys, heights);
  DiscContact contact{-std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i < kDiscPoints; ++i) {
    const double ahead = -kDiscSpan * radius + i * step;
    const double depth = heights[i] - (z - std::sqrt(radius * radius - ahead * ahead));
    if (depth > contact.deflection) contact = {depth, ahead};
  }
  return contact;
}

/// Upward force of the disc on its wheel: k delta + c rate, at least 0, nothing in the air.
inline double DiscForce(const DiscContact& contact, double radius, double stiffness, double damping,
                        double vx, double vz) {
  if (contact.deflection <= 0) return 0;
  const double s = contact.ahead;
  const double rate = vx * s / std::sqrt(radius * radius - s * s) - vz;
  return std::max(0.0, stiffness * contact.deflection + damping * rate);
}

inline void AddDiscForces(const VehicleModel& model, const Ground& ground,
                          const EngineState<double>& state, Workspace<double>& work) {
  for (std::size_t i = 0; i < model.wheels.size(); ++i) {
    const WheelModel& wheel = model.wheels[i];
    const BodyState<double>& body = state.bodies[wheel.body];
    const Vec3<double> lever = work.R_WB[wheel.body] * Broadcast<double>(wheel.p_BH);
    const Vec3<double> p = body.p_WB + lever;
    const Vec3<double> v = body.v_WB + Cross(body.w_WB, lever);
    const TireModel& tire = wheel.tire;
    const DiscContact contact = FindDiscContact(ground, tire.radius, p.x, p.y, p.z);
    const double load = DiscForce(contact, tire.radius, tire.stiffness, tire.damping, v.x, v.z);
    work.wrench[wheel.body].Add({0, 0, load}, lever);
    work.tires[i] = {};
    work.tires[i].load = load;
    work.tires[i].deflection = load / tire.stiffness;
  }
}

}  // namespace dbd
