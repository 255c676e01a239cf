#include <dbd/core/error.h>
#include <dbd/terrain/obstacle_map.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace dbd {
namespace {

// A range of cells [first, last] of one axis, cut to the grid; empty when last < first.
struct CellRange {
  int first;
  int last;
};

CellRange CellsBetween(double low, double high, double first_center, double cell_size, int count) {
  const double first = std::floor((low - first_center) / cell_size + 0.5);
  const double last = std::floor((high - first_center) / cell_size + 0.5);
  if (!(last >= 0 && first < count)) return {0, -1};
  return {static_cast<int>(std::max(0.0, first)),
          static_cast<int>(std::min<double>(count - 1, last))};
}

}  // namespace

ObstacleLayer::ObstacleLayer(const HeightMap::Grid& grid, std::vector<float> lowest)
    : grid_(grid), lowest_(std::move(lowest)) {
  DBD_ASSERT(lowest_.size() == grid_.CellCount());
}

bool ObstacleLayer::BlocksBox(const Eigen::Vector2d& center, double heading,
                              const Eigen::Vector2d& half_extents, double height) const {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const Eigen::Vector2d reach(std::abs(c) * half_extents.x() + std::abs(s) * half_extents.y(),
                              std::abs(s) * half_extents.x() + std::abs(c) * half_extents.y());
  const auto range = [&](int axis, int count) {
    return CellsBetween(center[axis] - reach[axis], center[axis] + reach[axis],
                        grid_.first_center[axis], grid_.cell_size[axis], count);
  };
  const CellRange columns = range(0, grid_.columns);
  const CellRange rows = range(1, grid_.rows);
  // A cell's square and the rectangle overlap unless an axis of the rectangle separates them; the
  // ranges above are the test along the axes of the square.
  const Eigen::Vector2d half_cell = 0.5 * grid_.cell_size;
  const Eigen::Vector2d limit =
      half_extents + Eigen::Vector2d(std::abs(c) * half_cell.x() + std::abs(s) * half_cell.y(),
                                     std::abs(s) * half_cell.x() + std::abs(c) * half_cell.y());
  for (int row = rows.first; row <= rows.last; ++row) {
    const float* line = lowest_.data() + static_cast<std::size_t>(row) * grid_.columns;
    for (int column = columns.first; column <= columns.last; ++column) {
      if (!(line[column] < height)) continue;
      const Eigen::Vector2d d = grid_.Center(column, row) - center;
      if (std::abs(c * d.x() + s * d.y()) <= limit.x() &&
          std::abs(c * d.y() - s * d.x()) <= limit.y()) {
        return true;
      }
    }
  }
  return false;
}

std::size_t ObstacleLayer::BlockedCells(double height) const {
  return static_cast<std::size_t>(std::count_if(
      lowest_.begin(), lowest_.end(), [height](float lowest) { return lowest < height; }));
}

ObstacleMap::ObstacleMap(const HeightMap::Grid& grid, std::vector<float> lowest) {
  layers_.emplace_back(grid, std::move(lowest));
}

void ObstacleMap::Add(ObstacleMap other) {
  std::move(other.layers_.begin(), other.layers_.end(), std::back_inserter(layers_));
}

bool ObstacleMap::Blocks(double x, double y, double height) const {
  return BlocksBox({x, y}, 0.0, Eigen::Vector2d::Zero(), height);
}

bool ObstacleMap::BlocksBox(const Eigen::Vector2d& center, double heading,
                            const Eigen::Vector2d& half_extents, double height) const {
  return std::any_of(layers_.begin(), layers_.end(), [&](const ObstacleLayer& layer) {
    return layer.BlocksBox(center, heading, half_extents, height);
  });
}

double ObstacleMap::BlockedShare(double height) const {
  std::size_t blocked = 0;
  std::size_t cells = 0;
  for (const ObstacleLayer& layer : layers_) {
    blocked += layer.BlockedCells(height);
    cells += layer.grid().CellCount();
  }
  return cells == 0 ? 0 : static_cast<double>(blocked) / static_cast<double>(cells);
}

std::size_t ObstacleMap::memory_bytes() const {
  std::size_t bytes = 0;
  for (const ObstacleLayer& layer : layers_) bytes += layer.memory_bytes();
  return bytes;
}

}  // namespace dbd
