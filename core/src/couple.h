#pragma once

#include <dbd/core/scene.h>

#include "engine_state.h"

namespace dbd {

// Forces between the chassis of two vehicles, one behind the other. Both evaluate them from the
// same published motion, so that the two sides are equal and opposite to the last bit.

/// Bumpers of a vehicle in its chassis frame.
struct Bumpers {
  double front = 0;  // x
  double rear = 0;   // x, negative
  double z = 0;
  double half_width = 0;

  Bumpers(const VehicleModel& vehicle, double height)
      : front(vehicle.outline.front),
        rear(-vehicle.outline.rear),
        z(height - vehicle.reference_height - vehicle.bodies[0].p_RB.z()),
        half_width(vehicle.outline.half_width) {}
};

/// What joins a vehicle to the one ahead, in their chassis frames.
struct Couple {
  Bumpers ahead;
  Bumpers behind;
  BumperModel bumper;
  bool towed = false;
  DrawbarModel drawbar;  // hitch and pivot in the chassis frames
};

/// A chassis as published, with its attitude as a matrix.
struct CoupledBody {
  const BodyState<double>& body;
  Mat3<double> R_WB = RotationMatrix(body.q_WB);

  BodyPoint<double> At(const Vec3<double>& p_B) const {
    const Vec3<double> lever = R_WB * p_B;
    return {lever, body.p_WB + lever, body.v_WB + Cross(body.w_WB, lever)};
  }
};

struct CoupleForces {
  Wrench<double> on_ahead{};
  Wrench<double> on_behind{};
  double bumper = 0;   // [N], pressing
  double drawbar = 0;  // [N], tension
};

/// One point of the front bumper behind against the rear plate ahead.
inline void AddBumperPoint(const Couple& couple, const CoupledBody& ahead,
                           const CoupledBody& behind, double y, CoupleForces& forces) {
  constexpr double kHalfHeight = 0.4;  // [m] of the plate
  constexpr double kThickness = 0.5;   // [m] beyond it the point has passed by
  const auto point = behind.At({couple.behind.front, y, couple.behind.z});
  const Vec3<double> lever_ahead = point.p - ahead.body.p_WB;
  const Vec3<double> p_A = ahead.R_WB.TransposeTimes(lever_ahead);
  const double depth = p_A.x - couple.ahead.rear;
  if (!(depth > 0) || depth > kThickness || std::abs(p_A.y) > couple.ahead.half_width ||
      std::abs(p_A.z - couple.ahead.z) > kHalfHeight) {
    return;
  }
  const Vec3<double>& forward = ahead.R_WB.x;
  const Vec3<double> v_plate = ahead.body.v_WB + Cross(ahead.body.w_WB, lever_ahead);
  const double elastic = couple.bumper.stiffness * depth;
  const double rate = Dot(point.v - v_plate, forward);
  const double push = Clamp(elastic + couple.bumper.damping * rate, 0.0, 2 * elastic);
  const Vec3<double> f = push * forward;
  forces.on_ahead.Add(f, lever_ahead);
  forces.on_behind.Add(-1.0 * f, point.lever);
  forces.bumper += push;
}

inline void AddDrawbar(const DrawbarModel& drawbar, const CoupledBody& ahead,
                       const CoupledBody& behind, CoupleForces& forces) {
  const auto hitch = ahead.At(Broadcast<double>(drawbar.hitch));
  const auto pivot = behind.At(Broadcast<double>(drawbar.pivot));
  const Vec3<double> d = hitch.p - pivot.p;
  const double length = Norm(d);
  const Vec3<double> direction = (1 / length) * d;
  const double tension = drawbar.stiffness * (length - drawbar.length) +
                         drawbar.damping * Dot(hitch.v - pivot.v, direction);
  const Vec3<double> f = tension * direction;
  forces.on_behind.Add(f, pivot.lever);
  forces.on_ahead.Add(-1.0 * f, hitch.lever);
  forces.drawbar = tension;
}

/// Whether the bumpers can touch at all.
inline bool AreNear(const Couple& couple, const BodyState<double>& ahead,
                    const BodyState<double>& behind) {
  const double reach =
      couple.behind.front - couple.ahead.rear + couple.ahead.half_width + couple.behind.half_width;
  const Vec3<double> d = ahead.p_WB - behind.p_WB;
  return Dot(d, d) < reach * reach;
}

inline CoupleForces EvaluateCouple(const Couple& couple, const BodyState<double>& ahead,
                                   const BodyState<double>& behind) {
  CoupleForces forces;
  if (!couple.towed && !AreNear(couple, ahead, behind)) return forces;
  const CoupledBody a{ahead}, b{behind};
  if (couple.towed) {
    AddDrawbar(couple.drawbar, a, b, forces);
    return forces;
  }
  for (const double side : {1.0, 0.0, -1.0}) {
    AddBumperPoint(couple, a, b, side * couple.behind.half_width, forces);
  }
  return forces;
}

/// From the middle of the front bumper behind to that of the rear one ahead, along the x axis of
/// the vehicle behind [m].
inline double BumperGap(const Couple& couple, const BodyState<double>& ahead,
                        const BodyState<double>& behind) {
  const CoupledBody a{ahead}, b{behind};
  const Vec3<double> rear = a.At({couple.ahead.rear, 0, couple.ahead.z}).p;
  const Vec3<double> front = b.At({couple.behind.front, 0, couple.behind.z}).p;
  return Dot(rear - front, b.R_WB.x);
}

/// Direction of the drawbar as the trailer sees it, left positive [rad].
inline double DrawbarAngle(const Couple& couple, const BodyState<double>& ahead,
                           const BodyState<double>& behind) {
  const CoupledBody a{ahead}, b{behind};
  const Vec3<double> d = a.At(Broadcast<double>(couple.drawbar.hitch)).p -
                         b.At(Broadcast<double>(couple.drawbar.pivot)).p;
  return std::atan2(Dot(d, b.R_WB.y), Dot(d, b.R_WB.x));
}

}  // namespace dbd
