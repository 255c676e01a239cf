#pragma once

#include <array>
#include <cstdint>

namespace dbd {

/// a x + b y + c.
template <class Number>
struct LinearFunction {
  Number a{}, b{}, c{};
};

/// A triangle seen from above, and the plane that it lies in.
template <class Number>
struct Facet {
  std::array<LinearFunction<Number>, 3> edges;  ///< distance inwards from each edge [m]
  LinearFunction<Number> height;                ///< [m]
};

/// A triangle as one of the bins keeps it: x and y [m] from the bin's south-west corner.
struct GroundFacet : Facet<float> {
  std::uint32_t triangle = 0;  ///< the same in every bin that keeps it
};

/// A place counts as on a facet up to this far beyond its edges, so that seams have no gaps [m].
inline constexpr float kFacetSeam = 1e-4F;

/// A triangulated surface as plain data, for readers that look many places up at once. The height
/// of a place is that of the lowest facet that it is on, and every such facet is kept in the bin
/// that the place lies in; off all facets the owner of the arrays is to be asked. That owner is the
/// ground that hands it out.
struct GroundFacets {
  int columns = 0;  ///< of bins, at least 1
  int rows = 0;
  double x0 = 0;  ///< south-west corner of bin (0, 0), in W [m]
  double y0 = 0;
  double bin_size = 1;                       ///< [m], positive
  double base_height = 0;                    ///< added to all heights below [m]
  const std::uint32_t* bin_begin = nullptr;  ///< columns x rows + 1, into `facets`
  const GroundFacet* facets = nullptr;
  const std::uint8_t* bin_has_rim = nullptr;  ///< 1 where an outline or a hole's rim goes through
};

}  // namespace dbd
