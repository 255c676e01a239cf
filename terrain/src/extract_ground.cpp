#include "extract_ground.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "ground_filter.h"
#include "load_tin.h"
#include "octree_file.h"

namespace dbd {
namespace {

constexpr double kMostCells = 6e7;

// Heights in the raster are relative to a whole metre.
struct LowestVoxels {
  HeightMap::Grid grid;  // in map coordinates
  double base_height = 0;
  HeightGrid heights;
};

template <typename Visit>
void ForEachOccupied(const octomap::OcTree& tree, Visit visit) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (tree.isNodeOccupied(*leaf)) visit(leaf);
  }
}

HeightMap::Grid GridOver(const TerrainFiles& files, const octomap::OcTree& tree, double cell) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  ForEachOccupied(tree, [&](const auto& leaf) {
    const Eigen::Vector2d center = files.elevation_placement.ToMap({leaf.getX(), leaf.getY()});
    const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * leaf.getSize());
    low = low.cwiseMin(center - half);
    high = high.cwiseMax(center + half);
  });
  if (!(low.x() < high.x())) throw InputError(files.elevation + ": holds no occupied voxel");
  const Eigen::Array2d cells = ((high - low) / cell).array().ceil().max(2);
  if (cells.prod() > kMostCells) {
    throw InputError(files.elevation + ": its ground would have more than 60 million cells; " +
                     "choose larger ones");
  }
  return {static_cast<int>(cells.x()), static_cast<int>(cells.y()),
          low + Eigen::Vector2d::Constant(0.5 * cell), Eigen::Vector2d::Constant(cell)};
}

// The middle of the lowest occupied voxel in each cell.
void Lower(const HeightMap::Grid& grid, const Eigen::Vector2d& place, float z,
           HeightGrid* heights) {
  const Eigen::Array2d cell = ((place - grid.first_center) / grid.cell_size.x()).array().round();
  const int column = std::clamp(static_cast<int>(cell.x()), 0, grid.columns - 1);
  const int row = std::clamp(static_cast<int>(cell.y()), 0, grid.rows - 1);
  float& lowest = heights->At(column, row);
  if (std::isnan(lowest) || z < lowest) lowest = z;
}

LowestVoxels FindLowest(const TerrainFiles& files, const octomap::OcTree& tree, double cell) {
  LowestVoxels lowest;
  lowest.grid = GridOver(files, tree, cell);
  lowest.base_height = std::round(tree.begin_leafs().getZ());
  lowest.heights = {
      lowest.grid.columns, lowest.grid.rows, cell,
      std::vector<float>(lowest.grid.CellCount(), std::numeric_limits<float>::quiet_NaN())};
  const double voxel = tree.getResolution();
  ForEachOccupied(tree, [&](const auto& leaf) {
    const int across = static_cast<int>(std::lround(leaf.getSize() / voxel));
    const double first = 0.5 * (voxel - leaf.getSize());
    const auto z = static_cast<float>(leaf.getZ() + first - lowest.base_height);
    for (int i = 0; i < across * across; ++i) {
      const Eigen::Vector2d in_tree(leaf.getX() + first + (i % across) * voxel,
                                    leaf.getY() + first + (i / across) * voxel);
      Lower(lowest.grid, files.elevation_placement.ToMap(in_tree), z, &lowest.heights);
    }
  });
  return lowest;
}

}  // namespace

ElevationRaster ExtractGround(const TerrainFiles& files, std::vector<std::string>* notes) {
  ElevationRaster raster;
  raster.map_wkt = raster.source_wkt = MetricCrs(files.elevation, files.crs);
  const std::unique_ptr<octomap::OcTree> tree = ReadOctree(files.elevation);
  const double voxel = tree->getResolution();
  const double cell = files.surface_cell_size > 0 ? files.surface_cell_size : 2 * voxel;
  LowestVoxels lowest = FindLowest(files, *tree, cell);
  // What stands on the ground may be as wide as a house.
  RemovePits(static_cast<float>(3 * voxel), &lowest.heights);
  RemoveWhatStands(1.5 * voxel, 0.35, 16, &lowest.heights);
  SmoothAndBridge(2, &lowest.heights);
  raster.grid = lowest.grid;
  raster.base_height = lowest.base_height;
  raster.heights = std::move(lowest.heights.heights);
  const auto unknown = std::count_if(raster.heights.begin(), raster.heights.end(),
                                     [](float height) { return std::isnan(height); });
  char text[160];
  std::snprintf(
      text, sizeof text,
      "the ground is extracted from voxels of %.3g m, on cells of %.3g m; under %.3g %% of "
      "the area the OctoMap holds none",
      voxel, cell,
      100.0 * static_cast<double>(unknown) / static_cast<double>(raster.heights.size()));
  notes->emplace_back(text);
  return raster;
}

}  // namespace dbd
