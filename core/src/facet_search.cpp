#include "facet_search.h"

#include <dbd/core/internal/clamp_index.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dbd {
namespace {

int BinAt(double distance, double bin_size, int bins) {
  return static_cast<int>(internal::ClampIndex(distance / bin_size, bins - 1.0));
}

double ValueAt(const LinearFunction<float>& function, double x, double y) {
  return double{function.a} * x + double{function.b} * y + double{function.c};
}

bool IsNear(const GroundFacet& facet, float radius, float x, float y) {
  const float least = -radius - 2 * kFacetSeam;  // one for rounding
  for (const LinearFunction<float>& edge : facet.edges) {
    if (!(edge.a * x + edge.b * y + edge.c >= least)) return false;
  }
  return true;
}

Facet<double> SeenFrom(const GroundFacet& facet, double x, double y) {
  const auto from_there = [&](const LinearFunction<float>& f) {
    return LinearFunction<double>{f.a, f.b, ValueAt(f, x, y)};
  };
  return {{from_there(facet.edges[0]), from_there(facet.edges[1]), from_there(facet.edges[2])},
          from_there(facet.height)};
}

/// With the mean slope of the facets, lifted over each of them.
LinearFunction<double> PlaneAbove(const FacetsNear& near, double radius) {
  LinearFunction<double> plane;
  for (int i = 0; i < near.count; ++i) {
    plane.a += near.facets[i].height.a / near.count;
    plane.b += near.facets[i].height.b / near.count;
  }
  plane.c = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < near.count; ++i) {
    const LinearFunction<double>& height = near.facets[i].height;
    const double da = height.a - plane.a, db = height.b - plane.b;
    const double steeper = std::sqrt(da * da + db * db);
    plane.c = std::max(plane.c, height.c + steeper * radius);
  }
  return plane;
}

}  // namespace

void FindFacetsNear(const GroundFacets& ground, double radius, double x, double y,
                    FacetsNear* near) {
  const double u = x - ground.x0, v = y - ground.y0;
  const double size = ground.bin_size;
  const int last_column = BinAt(u + radius, size, ground.columns);
  const int last_row = BinAt(v + radius, size, ground.rows);
  std::array<std::uint32_t, kMostFacetsNear> known;
  near->count = 0;
  near->whole = true;
  for (int row = BinAt(v - radius, size, ground.rows); row <= last_row; ++row) {
    for (int column = BinAt(u - radius, size, ground.columns); column <= last_column; ++column) {
      const std::int64_t bin = std::int64_t{row} * ground.columns + column;
      const double from_west = u - column * size, from_south = v - row * size;
      near->whole = near->whole && ground.bin_has_rim[bin] == 0;
      for (std::uint32_t i = ground.bin_begin[bin]; i < ground.bin_begin[bin + 1]; ++i) {
        const GroundFacet& facet = ground.facets[i];
        if (!IsNear(facet, static_cast<float>(radius), static_cast<float>(from_west),
                    static_cast<float>(from_south))) {
          continue;
        }
        const auto end = known.begin() + near->count;
        if (std::find(known.begin(), end, facet.triangle) != end) continue;
        if (near->count == kMostFacetsNear) {
          near->count = 0;
          near->whole = false;
          return;
        }
        known[near->count] = facet.triangle;
        near->facets[near->count++] = SeenFrom(facet, from_west, from_south);
      }
    }
  }
  near->whole = near->whole && near->count > 0;
  if (near->whole) near->bound = PlaneAbove(*near, radius);
}

}  // namespace dbd
