#pragma once

#include <cstdint>

namespace dbd {

struct SoilSample;

/// The soils of a ground as plain data, for readers that look many places up at once: one soil
/// everywhere, or a raster of classes (nearest cell). The owner of the arrays is the ground that
/// hands it out.
struct GroundSoils {
  const SoilSample* soils = nullptr;  ///< by class, as many as there are classes
  int count = 0;
  const std::uint8_t* classes = nullptr;  ///< rows x columns from the south-west; null: soils[0]
  int columns = 0;
  int rows = 0;
  double x0 = 0;  ///< south-west corner of cell (0, 0), in W [m]
  double y0 = 0;
  double cell_x = 1;  ///< [m], positive
  double cell_y = 1;
  std::uint8_t outside = 0;  ///< class beyond the raster
};

}  // namespace dbd
