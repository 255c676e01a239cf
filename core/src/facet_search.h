#pragma once

#include <dbd/core/ground_facets.h>

#include <array>

namespace dbd {

/// More triangles than this do not come near a tire where bins are wider than it reaches, but for
/// fans of slivers.
inline constexpr int kMostFacetsNear = 24;

/// Facets within a circle: x and y from its middle, heights from the base.
struct FacetsNear {
  std::array<Facet<double>, kMostFacetsNear> facets;
  int count = 0;
  bool whole = false;            ///< every place of the circle is on one of them
  LinearFunction<double> bound;  ///< a plane that then none of these places is above
};

/// All facets that places within `radius` [m] of (x, y), in W, may be on. None at all where they
/// are more than fit.
void FindFacetsNear(const GroundFacets& ground, double radius, double x, double y,
                    FacetsNear* near);

}  // namespace dbd
