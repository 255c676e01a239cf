#include <dbd/core/error.h>
#include <dbd/terrain/obstacle_map.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <utility>

#include "octree_file.h"

namespace dbd {
namespace {

constexpr double kMaxLayerCells = 1e9;  // 4 GB

// Unseen space is looked for up to here above the ground [m].
constexpr double kUnknownReach = 5.0;

struct Leaf {
  Eigen::Vector2d center;  // in W [m]
  double bottom;           // [m]
  double side;             // [m]
};

template <typename Visit>
void ForEachOccupied(const octomap::OcTree& tree, const MapPlacement& placement, Visit visit) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const double side = leaf.getSize();
    visit(Leaf{placement.ToMap({leaf.getX(), leaf.getY()}), leaf.getZ() - 0.5 * side, side});
  }
}

// Half the width of the axis-parallel box round a turned square of side 1.
double HalfReach(const MapPlacement& placement) {
  return 0.5 * (std::abs(std::cos(placement.yaw)) + std::abs(std::sin(placement.yaw)));
}

struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
};

Extent ExtentOf(const octomap::OcTree& tree, const MapPlacement& placement) {
  Extent extent;
  const double half_reach = HalfReach(placement);
  ForEachOccupied(tree, placement, [&](const Leaf& leaf) {
    const Eigen::Vector2d half = Eigen::Vector2d::Constant(half_reach * leaf.side);
    extent.low = extent.low.cwiseMin(leaf.center - half);
    extent.high = extent.high.cwiseMax(leaf.center + half);
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

// The same, of everything on the ground, whole voxels from the octree's corner.
Extent GroundExtent(const Extent& octree, double resolution, const HeightMap& ground) {
  const Eigen::Vector2d half_cell = 0.5 * ground.grid().cell_size;
  const auto whole = [&](const Eigen::Vector2d& place, double direction) -> Eigen::Vector2d {
    const Eigen::Array2d steps = (place - octree.low).array() / resolution * direction;
    return octree.low + (steps.ceil() * direction * resolution).matrix();
  };
  return {whole(ground.min_corner() - half_cell, -1), whole(ground.max_corner() + half_cell, 1)};
}

// Lowest obstacle above the ground in each cell.
class Projection {
 public:
  Projection(const HeightMap& ground, const HeightMap::Grid& grid, const MapPlacement& placement,
             double floor)
      : ground_(ground),
        grid_(grid),
        placement_(placement),
        floor_(floor),
        half_reach_(HalfReach(placement)),
        lowest_(grid.CellCount(), std::numeric_limits<float>::infinity()) {}

  void Add(const Leaf& leaf) {
    const double resolution = grid_.cell_size.x();
    // A hair less, so that a leaf does not touch the neighbours that it only borders on.
    const Eigen::Vector2d half =
        Eigen::Vector2d::Constant(half_reach_ * leaf.side - 1e-3 * resolution);
    const auto [first_column, last_column] = Cells(leaf.center, half, 0, grid_.columns);
    const auto [first_row, last_row] = Cells(leaf.center, half, 1, grid_.rows);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const Eigen::Vector2d center = grid_.Center(column, row);
        if (!Touches(leaf, center)) continue;
        const double above_ground = leaf.bottom - ground_.Height(center.x(), center.y());
        Lower(column, row, LowestObstacle(above_ground, leaf.side, resolution, floor_));
      }
    }
  }

  void AddUnknownSpace(const octomap::OcTree& tree) {
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) AddUnknownColumn(tree, column, row);
    }
  }

  std::vector<float> Take() { return std::move(lowest_); }

 private:
  std::pair<int, int> Cells(const Eigen::Vector2d& center, const Eigen::Vector2d& half, int axis,
                            int count) const {
    const auto cell = [&](double place) {
      return std::floor((place - grid_.first_center[axis]) / grid_.cell_size[axis] + 0.5);
    };
    return {static_cast<int>(std::max(0.0, cell(center[axis] - half[axis]))),
            static_cast<int>(std::min(count - 1.0, cell(center[axis] + half[axis])))};
  }

  // The turned square of the leaf and the square of the cell; along the grid's axes they do.
  bool Touches(const Leaf& leaf, const Eigen::Vector2d& cell_center) const {
    if (placement_.yaw == 0) return true;
    const double limit = 0.5 * leaf.side + half_reach_ * grid_.cell_size.x();
    const MapPlacement turned{leaf.center, placement_.yaw};
    return turned.FromMap(cell_center).cwiseAbs().maxCoeff() <= limit;
  }

  void AddUnknownColumn(const octomap::OcTree& tree, int column, int row) {
    const Eigen::Vector2d center = grid_.Center(column, row);
    const Eigen::Vector2d place = placement_.FromMap(center);
    const double bottom = ground_.Height(center.x(), center.y());
    for (double z = floor_; z < kUnknownReach; z += grid_.cell_size.x()) {
      if (tree.search(place.x(), place.y(), bottom + z) != nullptr) continue;
      Lower(column, row, z);
      return;
    }
  }

  void Lower(int column, int row, double height) {
    float& lowest = lowest_[static_cast<std::size_t>(row) * grid_.columns + column];
    lowest = std::min(lowest, static_cast<float>(height));
  }

  const HeightMap& ground_;
  HeightMap::Grid grid_;
  MapPlacement placement_;
  double floor_;
  double half_reach_;
  std::vector<float> lowest_;
};

}  // namespace

ObstacleMap LoadObstacles(const std::string& file, const HeightMap& ground,
                          const MapPlacement& placement, double floor, UnknownSpace unknown_space) {
  const std::unique_ptr<octomap::OcTree> tree = ReadOctree(file);
  const double resolution = tree->getResolution();
  const Extent occupied = ExtentOf(*tree, placement);
  if (!(occupied.low.x() < occupied.high.x())) return {};
  const bool covers_ground = unknown_space == UnknownSpace::kBlocked;
  const HeightMap::Grid grid =
      LayerGrid(file, covers_ground ? GroundExtent(occupied, resolution, ground) : occupied,
                resolution, ground);
  Projection projection(ground, grid, placement, floor);
  ForEachOccupied(*tree, placement, [&](const Leaf& leaf) { projection.Add(leaf); });
  if (covers_ground) projection.AddUnknownSpace(*tree);
  return ObstacleMap(grid, projection.Take());
}

}  // namespace dbd
