#pragma once

#include <dbd/core/ground.h>

#include <memory>
#include <vector>

namespace dbd {

/// Heights at the nodes of a square grid, x fastest.
struct NodeGrid {
  int columns = 0;
  int rows = 0;
  double x0 = 0;  // of the first node
  double y0 = 0;
  double spacing = 1;
  std::vector<double> heights;

  std::size_t Index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(ix);
  }
};

std::shared_ptr<const Ground> MakeGridGround(const NodeGrid& grid);

}  // namespace dbd
