#pragma once

#include <vector>

namespace dbd {

/// A grid of heights, not a number where unknown.
struct HeightGrid {
  int columns = 0;
  int rows = 0;
  double cell_size = 1;  ///< [m]
  std::vector<float> heights;

  float& At(int column, int row) {
    return heights[static_cast<std::size_t>(row) * columns + column];
  }
  float At(int column, int row) const {
    return heights[static_cast<std::size_t>(row) * columns + column];
  }
};

/// Makes unknown what lies more than `drop` below the median of its 5 x 5 cells.
void RemovePits(float drop, HeightGrid* grid);

/// Makes unknown what stands on the ground: more than step + slope * window above the opening of
/// the grid, for windows that double up to `widest` [m].
void RemoveWhatStands(double step, double slope, double widest, HeightGrid* grid);

/// Gaps up to `reach` cells wide become the mean of the known cells around; known cells become
/// the mean of themselves and their neighbours within `reach`.
void SmoothAndBridge(int reach, HeightGrid* grid);

}  // namespace dbd
