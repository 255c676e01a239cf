#pragma once

namespace dbd {

/// A regular grid of ground heights as plain data, for readers that look many places up at once.
/// Bilinear between cell centres; outside the grid the height of its edge continues. The owner of
/// the arrays is the ground that hands it out.
struct GroundGrid {
  int columns = 0;  ///< at least 2
  int rows = 0;     ///< at least 2
  double x0 = 0;    ///< of the centre of cell (0, 0), in W [m]
  double y0 = 0;
  double cell_x = 1;  ///< [m], positive
  double cell_y = 1;
  double base_height = 0;  ///< added to all heights below [m]
  /// (rows - 1) x columns pairs {this row, the row to its north}, so that the four corners of a
  /// place are one read.
  const float* row_pairs = nullptr;

  /// Highest height in each tile of tile_cells x tile_cells squares and in its eight neighbours.
  int tile_cells = 1;
  int tile_columns = 0;
  double tile_width = 0;  ///< the smaller side [m]: one read bounds this radius
  const float* highest_nearby = nullptr;
};

}  // namespace dbd
