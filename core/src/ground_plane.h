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

/// Level, at the highest ground within `radius` of p.
template <class Surface, class Real>
GroundPlane<Real> LevelBound(const Surface& ground, double radius, const Vec3<Real>& p) {
  GroundPlane<Real> bound;
  ground.HighestWithin(radius, 1, &p.x, &p.y, &bound.height);
  return bound;
}

}  // namespace dbd
