#include <dbd/terrain/terrain_info.h>
#include <dbd/terrain/tin_surface.h>

#include <algorithm>
#include <cmath>

#include "crs_definition.h"

namespace dbd {
namespace {

constexpr double kVehicleHeight = 2.0;  // what counts as in the way [m]

// The cell and its four neighbours have heights.
bool HasSlope(const HeightMap& heights, int column, int row) {
  return heights.IsCellKnown(column, row) && heights.IsCellKnown(column - 1, row) &&
         heights.IsCellKnown(column + 1, row) && heights.IsCellKnown(column, row - 1) &&
         heights.IsCellKnown(column, row + 1);
}

// Squares of the gradients, in no order; they sort as the angles do.
std::vector<float> SquaredGradients(const HeightMap& heights) {
  const HeightMap::Grid& grid = heights.grid();
  const Eigen::Vector2d scale = (2 * grid.cell_size).cwiseInverse();
  std::vector<float> squares;
  squares.reserve(grid.CellCount());
  for (int row = 1; row + 1 < grid.rows; ++row) {
    for (int column = 1; column + 1 < grid.columns; ++column) {
      if (!HasSlope(heights, column, row)) continue;
      const double east = heights.CellHeight(column + 1, row) - heights.CellHeight(column - 1, row);
      const double north =
          heights.CellHeight(column, row + 1) - heights.CellHeight(column, row - 1);
      squares.push_back(
          static_cast<float>(std::pow(east * scale.x(), 2) + std::pow(north * scale.y(), 2)));
    }
  }
  return squares;
}

// Angle [rad] that this share of the places is below.
double SlopeQuantile(double share, std::vector<float>* values) {
  if (values->empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values->size() - 1));
  std::nth_element(values->begin(), values->begin() + rank, values->end());
  return std::atan(std::sqrt(double{(*values)[static_cast<std::size_t>(rank)]}));
}

void DescribeHeights(const Terrain& terrain, TerrainInfo* info) {
  const HeightMap& heights = terrain.heights();
  const HeightMap::Grid& grid = heights.grid();
  info->columns = grid.columns;
  info->rows = grid.rows;
  info->cell_size = grid.cell_size;
  info->extent = grid.cell_size.cwiseProduct(Eigen::Vector2d(grid.columns, grid.rows));
  info->map_min = terrain.frame().ToMap(heights.min_corner() - 0.5 * grid.cell_size);
  info->map_max = info->map_min + info->extent;
  const LocalFrame& frame = terrain.frame();
  info->file_south_west = frame.ToSource(frame.ToLocal(info->map_min));
  info->file_north_east = frame.ToSource(frame.ToLocal(info->map_max));
  info->lowest = heights.lowest();
  info->highest = heights.highest();
  info->unknown_share = heights.unknown_share();
  std::vector<float> squares = SquaredGradients(heights);
  info->median_slope = SlopeQuantile(0.5, &squares);
  info->slope_90_percent = SlopeQuantile(0.9, &squares);
  info->slope_99_percent = SlopeQuantile(0.99, &squares);
  info->steepest_slope = SlopeQuantile(1.0, &squares);
}

void DescribeMaterials(const MaterialMap& map, TerrainInfo* info) {
  const std::vector<Material>& materials = map.table().materials();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const double share = map.Share(static_cast<std::uint8_t>(i));
    if (share > 0) info->materials.push_back({materials[i].name, share, materials[i].passable});
  }
  info->unknown_material_share = map.Share(MaterialMap::kNone);
}

}  // namespace

TerrainInfo DescribeTerrain(const Terrain& terrain) {
  TerrainInfo info;
  DescribeHeights(terrain, &info);
  DescribeMaterials(terrain.materials(), &info);
  info.crs_name = terrain.frame().CrsName();
  const std::string& file_wkt = terrain.frame().source_wkt();
  info.file_crs_name = file_wkt.empty() ? info.crs_name : CrsDefinitionName(file_wkt);
  info.memory_bytes = terrain.heights().memory_bytes() + terrain.materials().memory_bytes() +
                      terrain.obstacles().memory_bytes() +
                      (terrain.tin() != nullptr ? terrain.tin()->memory_bytes() : 0);
  info.has_obstacles = !terrain.obstacles().empty();
  if (info.has_obstacles) {
    info.obstacle_cell_size = terrain.obstacles().layers().front().grid().cell_size.x();
    info.obstacle_share = terrain.obstacles().BlockedShare(kVehicleHeight);
  }
  return info;
}

}  // namespace dbd
