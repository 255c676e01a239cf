#pragma once

#include <dbd/terrain/terrain.h>

#include <cstdint>
#include <vector>

#include "map_style.h"
#include "map_view.h"

namespace dbd {

/// A picture of the ground, one 0xffRRGGBB per pixel, rows from north to south.
struct ReliefImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
  double contour_interval = 0;  ///< [m], 0 = no contours drawn
  /// Materials in view, in the order of their table; their tint is `MaterialTint` of their place
  /// in this list. Empty when the material is the same everywhere.
  std::vector<const Material*> materials;
};

/// Tint of the ground: one of a few colours that stay apart, or blue where nobody may drive.
Color MaterialTint(const Material& material, std::size_t place);

/// Shaded relief (Horn's gradient, lit from the north-west) over a tint by height, with faint
/// contours, soils, obstacles lower than `obstacle_height` [m], and unknown ground hatched.
ReliefImage RenderRelief(const Terrain& terrain, const MapView& view, double obstacle_height);

}  // namespace dbd
