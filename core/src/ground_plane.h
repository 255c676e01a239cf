#pragma once

#include <dbd/core/ground.h>

#include "vec.h"

namespace dbd {

/// A plane that the ground near a place is nowhere above.
template <class Real>
struct GroundPlane {
  Real height{0};   ///< at the place itself [m]
  Real slope_x{0};  ///< rise per metre east
  Real slope_y{0};  ///< and north
};

/// Of the ground within `radius` of p, for one vehicle: the highest ground there.
inline GroundPlane<double> BoundUnder(const Ground& ground, double radius, const Vec3<double>& p) {
  GroundPlane<double> bound;
  ground.HighestWithin(radius, 1, &p.x, &p.y, &bound.height);
  return bound;
}

/// For packs of vehicles.
template <class Surface, class Real>
GroundPlane<Real> BoundUnder(const Surface& ground, double radius, const Vec3<Real>& p) {
  return ground.Bound(radius, p.x, p.y);
}

}  // namespace dbd
