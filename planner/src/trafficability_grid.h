#pragma once

#include <dbd/planner/stop.h>
#include <dbd/terrain/terrain.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dbd {

// What takes long throws StopRequested soon after `stop` was asked to.

/// Heights sampled on a square grid over W; row 0 is the south edge.
struct HeightGrid {
  int columns = 0;
  int rows = 0;
  double resolution = 1;       ///< [m]
  std::vector<float> heights;  ///< relative to the lowest ground [m]
  std::vector<std::uint8_t> known;

  std::size_t Index(int column, int row) const {
    return static_cast<std::size_t>(row) * columns + column;
  }
};

/// Of the surface that the wheels touch: a TIN's triangles, not its raster.
HeightGrid SampleHeights(const Terrain& terrain, const Eigen::Vector2d& min_corner, int columns,
                         int rows, double resolution, const std::stop_token& stop = {});

/// Least-squares plane about one cell.
struct PlaneFit {
  float grade_x = 0;  ///< [-]
  float grade_y = 0;
  float roughness = 0;  ///< rms distance of the heights from the plane [m]
};

/// Planes fitted to the (2 k + 1)^2 heights about each cell, k = `half_window` >= 1. Cells whose
/// square leaves the grid get the plane of the nearest cell whose square does not, or a level one
/// when there is none. Cost per cell grows with k, not with its square.
std::vector<PlaneFit> FitPlanes(const HeightGrid& grid, int half_window,
                                const std::stop_token& stop = {});

/// Cells on either side of a step: a difference between neighbours, less the mean of the
/// differences before and after it, above `limit` [m].
std::vector<std::uint8_t> FindSteps(const HeightGrid& grid, double limit);

/// Cells with anything marked within `half_window` cells in x and y.
std::vector<std::uint8_t> Dilate(const std::vector<std::uint8_t>& marks, int columns, int rows,
                                 int half_window, const std::stop_token& stop = {});

}  // namespace dbd
