#pragma once

#include <cstddef>
#include <cstdint>

namespace dbd {

struct SoilSample;

/// Where the cells of a raster lie, each around its centre.
struct CellGrid {
  int columns = 0;
  int rows = 0;
  double first_x = 0;  ///< centre of the cell in the south-west, in W [m]
  double first_y = 0;
  double per_x = 1;  ///< cells per metre, positive
  double per_y = 1;

  /// Index, row by row from the south-west, of the cell that holds a place; negative beyond the
  /// raster. Always inlined: wide and portable code must not share a function.
  [[gnu::always_inline]] std::ptrdiff_t CellAt(double x, double y) const {
    const double u = (x - first_x) * per_x + 0.5, v = (y - first_y) * per_y + 0.5;
    const bool inside = u >= 0 && u < columns && v >= 0 && v < rows;
    if (!inside) return -1;
    return static_cast<std::ptrdiff_t>(v) * columns + static_cast<std::ptrdiff_t>(u);
  }
};

/// The soils of a ground as plain data, for readers that look many places up at once: one soil
/// everywhere, or a raster of classes. The owner of the arrays is the ground that hands it out.
struct GroundSoils {
  const SoilSample* soils = nullptr;  ///< by class, as many as there are classes
  int count = 0;
  const std::uint8_t* classes = nullptr;  ///< one per cell of `grid`; null: soils[0] everywhere
  CellGrid grid;
  std::uint8_t outside = 0;  ///< class beyond the raster
};

}  // namespace dbd
