#include <dbd/core/error.h>
#include <dbd/terrain/obstacle_map.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "octree_file.h"

namespace dbd {
namespace {

constexpr double kMaxLayerCells = 1e9;  // 4 GB

struct Leaf {
  Eigen::Vector2d low;  // south-west corner in W [m]
  double bottom;        // [m]
  double side;          // [m]
};

template <typename Visit>
void ForEachOccupied(const octomap::OcTree& tree, const Eigen::Vector2d& offset, Visit visit) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const double side = leaf.getSize();
    const Eigen::Vector2d center(leaf.getX(), leaf.getY());
    visit(Leaf{center + offset - Eigen::Vector2d::Constant(0.5 * side), leaf.getZ() - 0.5 * side,
               side});
  }
}

// First and one past the last cell centre inside the ground.
Eigen::Vector2i ClampCell(const Eigen::Vector2d& cell, const HeightMap::Grid& grid) {
  return {static_cast<int>(std::clamp(cell.x(), 0.0, static_cast<double>(grid.columns))),
          static_cast<int>(std::clamp(cell.y(), 0.0, static_cast<double>(grid.rows)))};
}

struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
};

Extent ExtentOf(const octomap::OcTree& tree, const Eigen::Vector2d& offset) {
  Extent extent;
  ForEachOccupied(tree, offset, [&extent](const Leaf& leaf) {
    extent.low = extent.low.cwiseMin(leaf.low);
    extent.high = extent.high.cwiseMax(leaf.low + Eigen::Vector2d::Constant(leaf.side));
  });
  return extent;
}

[[noreturn]] void FailOutside(const std::string& file, const Extent& octree,
                              const HeightMap& ground) {
  char text[300];
  std::snprintf(text, sizeof text,
                ": all obstacles lie outside the terrain: x %.1f to %.1f, y %.1f to %.1f, the "
                "terrain has x %.1f to %.1f, y %.1f to %.1f (local metres); is the obstacles' "
                "origin right?",
                octree.low.x(), octree.high.x(), octree.low.y(), octree.high.y(),
                ground.min_corner().x(), ground.max_corner().x(), ground.min_corner().y(),
                ground.max_corner().y());
  throw InputError(file + text);
}

// Voxel columns that hold an obstacle or lie between them, inside the ground.
HeightMap::Grid LayerGrid(const std::string& file, const Extent& octree, double resolution,
                          const HeightMap& ground) {
  const Eigen::Vector2d half_cell = 0.5 * ground.grid().cell_size;
  const Eigen::Vector2d low = octree.low.cwiseMax(ground.min_corner() - half_cell);
  const Eigen::Vector2d high = octree.high.cwiseMin(ground.max_corner() + half_cell);
  if (!(low.array() < high.array()).all()) FailOutside(file, octree, ground);
  // Whole voxels from the octree's corner, so that layer and voxels stay aligned.
  const Eigen::Array2d first = ((low - octree.low) / resolution).array().floor();
  const Eigen::Array2d last =
      ((high - octree.low) / resolution - Eigen::Vector2d::Constant(1e-6)).array().floor();
  const Eigen::Array2d size = last - first + 1;
  if (size.prod() > kMaxLayerCells) {
    throw InputError(file + ": its obstacles need more than 4 GB at this resolution");
  }
  HeightMap::Grid grid;
  grid.columns = static_cast<int>(size.x());
  grid.rows = static_cast<int>(size.y());
  grid.cell_size = Eigen::Vector2d::Constant(resolution);
  grid.first_center = octree.low + ((first + 0.5) * resolution).matrix();
  return grid;
}

// Bottom above ground of the leaf's lowest voxel that is not ground; a leaf stands for
// (side / resolution)^3 voxels. Infinity when all are ground.
double LowestObstacle(double bottom, double side, double resolution, double floor) {
  if (bottom >= floor) return bottom;
  const double raised = std::ceil((floor - bottom) / resolution) * resolution;
  return raised < side - 0.5 * resolution ? bottom + raised
                                          : std::numeric_limits<double>::infinity();
}

}  // namespace

ObstacleMap LoadObstacles(const std::string& file, const HeightMap& ground,
                          const Eigen::Vector2d& offset, double floor) {
  const std::unique_ptr<octomap::OcTree> tree = ReadOctree(file);
  const double resolution = tree->getResolution();
  const Extent extent = ExtentOf(*tree, offset);
  if (!(extent.low.x() < extent.high.x())) return {};
  const HeightMap::Grid grid = LayerGrid(file, extent, resolution, ground);
  const Eigen::Vector2d corner = grid.first_center - Eigen::Vector2d::Constant(0.5 * resolution);
  std::vector<float> lowest(grid.CellCount(), std::numeric_limits<float>::infinity());
  ForEachOccupied(*tree, offset, [&](const Leaf& leaf) {
    const Eigen::Vector2d cell = (leaf.low - corner) / resolution;
    const Eigen::Vector2d rounded(std::round(cell.x()), std::round(cell.y()));
    const double across = std::round(leaf.side / resolution);
    const Eigen::Vector2i begin = ClampCell(rounded, grid);
    const Eigen::Vector2i end = ClampCell(rounded + Eigen::Vector2d::Constant(across), grid);
    for (int row = begin.y(); row < end.y(); ++row) {
      for (int column = begin.x(); column < end.x(); ++column) {
        const Eigen::Vector2d center = grid.Center(column, row);
        const double above_ground = leaf.bottom - ground.Height(center.x(), center.y());
        const double obstacle = LowestObstacle(above_ground, leaf.side, resolution, floor);
        float& best = lowest[static_cast<std::size_t>(row) * grid.columns + column];
        best = std::min(best, static_cast<float>(obstacle));
      }
    }
  });
  return ObstacleMap(grid, std::move(lowest));
}

}  // namespace dbd
