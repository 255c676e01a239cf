#include <dbd/core/error.h>
#include <dbd/core/internal/clamp_index.h>
#include <dbd/core/internal/huge_pages.h>
#include <dbd/terrain/height_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continue_heights.h"

namespace dbd {
namespace {

using internal::ClampIndex;

// Tiles of the bound are about this wide where cells are smaller: a wheel's radius fits [m].
constexpr double kTileWidth = 0.5;

// Tiles of an n-cell axis.
int TileCount(int cells, int tile_cells) { return (cells - 2) / tile_cells + 1; }

// The square that holds an index coordinate; the last point belongs to the last square.
int SquareOf(double index, double last) {
  return static_cast<int>(index < last - 1.0 ? index : last - 1.0);
}

}  // namespace

HeightMap::HeightMap(const Grid& grid, std::vector<float> heights, double base_height)
    : grid_(grid),
      base_height_(base_height),
      inverse_cell_size_(grid.cell_size.cwiseInverse()),
      last_index_(grid.columns - 1, grid.rows - 1) {
  if (grid.columns < 2 || grid.rows < 2) {
    throw InputError("a height map needs at least 2 x 2 cells, got " +
                     std::to_string(grid.columns) + " x " + std::to_string(grid.rows));
  }
  DBD_ASSERT(heights.size() == grid.CellCount());
  DBD_ASSERT(grid.cell_size.minCoeff() > 0);
  MarkKnown(heights);
  if (unknown_share_ > 0) ContinueHeightsIntoUnknown(&heights);
  StoreRowPairs(heights);
  BuildHighestTiles(heights);
}

double HeightMap::Height(double x, double y) const {
  double z = 0;
  Heights(1, &x, &y, &z);
  return z;
}

// Two passes over a block: the arithmetic of the first is done for several places at once by the
// compiler, the reads of the second are not.
void HeightMap::Heights(int count, const double* x, const double* y, double* z) const {
  constexpr int kBlock = 16;
  const double last_u = last_index_.x();
  const double last_v = last_index_.y();
  const auto columns = static_cast<std::size_t>(grid_.columns);
  double east[kBlock];
  double north[kBlock];
  int column[kBlock];
  int row[kBlock];
  for (int first = 0; first < count; first += kBlock) {
    const int size = std::min(kBlock, count - first);
    for (int k = 0; k < size; ++k) {
      const double u =
          ClampIndex((x[first + k] - grid_.first_center.x()) * inverse_cell_size_.x(), last_u);
      const double v =
          ClampIndex((y[first + k] - grid_.first_center.y()) * inverse_cell_size_.y(), last_v);
      column[k] = SquareOf(u, last_u);
      row[k] = SquareOf(v, last_v);
      east[k] = u - column[k];
      north[k] = v - row[k];
    }
    for (int k = 0; k < size; ++k) {
      const RowPair* west =
          row_pairs_.data() + static_cast<std::size_t>(row[k]) * columns + column[k];
      const double south_z = west[0].south + east[k] * (double{west[1].south} - west[0].south);
      const double north_z = west[0].north + east[k] * (double{west[1].north} - west[0].north);
      z[first + k] = base_height_ + (south_z + north[k] * (north_z - south_z));
    }
  }
}

double HeightMap::HighestWithin(double radius, double x, double y) const {
  const double u =
      ClampIndex((x - grid_.first_center.x()) * inverse_cell_size_.x(), last_index_.x());
  const double v =
      ClampIndex((y - grid_.first_center.y()) * inverse_cell_size_.y(), last_index_.y());
  const int column = SquareOf(u, last_index_.x()) / tile_cells_;
  const int row = SquareOf(v, last_index_.y()) / tile_cells_;
  const auto at = [this](int tile_column, int tile_row) {
    return highest_nearby_[static_cast<std::size_t>(tile_row) * tile_columns_ + tile_column];
  };
  if (radius <= tile_width_) return base_height_ + at(column, row);

  // Each tile answers for its neighbours too, so one less ring is read.
  const double rings = std::min(1e6, std::ceil(radius / tile_width_) - 1.0);
  const int reach = static_cast<int>(rings);
  float highest = -std::numeric_limits<float>::infinity();
  for (int r = std::max(0, row - reach); r <= std::min(tile_rows_ - 1, row + reach); ++r) {
    for (int c = std::max(0, column - reach); c <= std::min(tile_columns_ - 1, column + reach);
         ++c) {
      highest = std::max(highest, at(c, r));
    }
  }
  return base_height_ + highest;
}

bool HeightMap::IsKnown(double x, double y) const {
  const double u = (x - grid_.first_center.x()) * inverse_cell_size_.x();
  const double v = (y - grid_.first_center.y()) * inverse_cell_size_.y();
  const bool inside = u >= 0 && u <= last_index_.x() && v >= 0 && v <= last_index_.y();
  if (!inside) return false;
  if (unknown_share_ == 0) return true;
  const int column = SquareOf(u, last_index_.x());
  const int row = SquareOf(v, last_index_.y());
  return IsCellKnown(column, row) && IsCellKnown(column + 1, row) && IsCellKnown(column, row + 1) &&
         IsCellKnown(column + 1, row + 1);
}

bool HeightMap::IsBoxKnown(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  constexpr int kMostCells = 64;
  const Eigen::Vector2d first = (low - grid_.first_center).cwiseProduct(inverse_cell_size_);
  const Eigen::Vector2d last = (high - grid_.first_center).cwiseProduct(inverse_cell_size_);
  const bool inside = first.x() >= 0 && first.y() >= 0 && last.x() <= last_index_.x() &&
                      last.y() <= last_index_.y();
  if (!inside || unknown_share_ == 0) return inside;
  const int west = SquareOf(first.x(), last_index_.x()), east = SquareOf(last.x(), last_index_.x());
  const int south = SquareOf(first.y(), last_index_.y());
  const int north = SquareOf(last.y(), last_index_.y());
  if (std::max(east - west, north - south) + 2 > kMostCells ||
      (east - west + 2) * (north - south + 2) > kMostCells) {
    return false;
  }
  for (int row = south; row <= north + 1; ++row) {
    for (int column = west; column <= east + 1; ++column) {
      if (!IsCellKnown(column, row)) return false;
    }
  }
  return true;
}

bool HeightMap::IsCellKnown(int column, int row) const {
  return known_[static_cast<std::size_t>(row) * grid_.columns + column] != 0;
}

double HeightMap::CellHeight(int column, int row) const {
  const bool last_row = row == grid_.rows - 1;
  const RowPair& pair =
      row_pairs_[static_cast<std::size_t>(last_row ? row - 1 : row) * grid_.columns + column];
  return base_height_ + double{last_row ? pair.north : pair.south};
}

GroundGrid HeightMap::View() const {
  GroundGrid view;
  view.columns = grid_.columns;
  view.rows = grid_.rows;
  view.x0 = grid_.first_center.x();
  view.y0 = grid_.first_center.y();
  view.cell_x = grid_.cell_size.x();
  view.cell_y = grid_.cell_size.y();
  view.base_height = base_height_;
  view.row_pairs = &row_pairs_.front().south;
  view.tile_cells = tile_cells_;
  view.tile_columns = tile_columns_;
  view.tile_width = tile_width_;
  view.highest_nearby = highest_nearby_.data();
  return view;
}

std::size_t HeightMap::memory_bytes() const {
  return row_pairs_.size() * sizeof(RowPair) + known_.size() +
         highest_nearby_.size() * sizeof(float);
}

std::size_t HeightMap::MemoryNeed(std::size_t cells) {
  return cells * (sizeof(RowPair) + sizeof(std::uint8_t) + sizeof(float));
}

void HeightMap::MarkKnown(const std::vector<float>& heights) {
  known_.resize(heights.size());
  std::size_t unknown = 0;
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    known_[i] = std::isfinite(heights[i]);
    if (known_[i]) {
      lowest = std::min(lowest, heights[i]);
      highest = std::max(highest, heights[i]);
    } else {
      ++unknown;
    }
  }
  if (unknown == heights.size()) throw InputError("no cell of the height map is known");
  unknown_share_ = static_cast<double>(unknown) / static_cast<double>(heights.size());
  lowest_ = base_height_ + lowest;
  highest_ = base_height_ + highest;
}

void HeightMap::ContinueHeightsIntoUnknown(std::vector<float>* heights) const {
  ContinueFromNearest(grid_.columns, grid_.rows, grid_.cell_size, known_, heights);
}

void HeightMap::StoreRowPairs(const std::vector<float>& heights) {
  const auto columns = static_cast<std::size_t>(grid_.columns);
  const std::size_t pairs = columns * static_cast<std::size_t>(grid_.rows - 1);
  row_pairs_.reserve(pairs);
  internal::AdviseHugePages(row_pairs_.data(), pairs * sizeof(RowPair));
  row_pairs_.resize(pairs);
  for (std::size_t i = 0; i < row_pairs_.size(); ++i) {
    row_pairs_[i] = {heights[i], heights[i + columns]};
  }
}

void HeightMap::BuildHighestTiles(const std::vector<float>& heights) {
  tile_cells_ = std::max(1, static_cast<int>(kTileWidth / grid_.cell_size.minCoeff()));
  tile_width_ = tile_cells_ * grid_.cell_size.minCoeff();
  tile_columns_ = TileCount(grid_.columns, tile_cells_);
  tile_rows_ = TileCount(grid_.rows, tile_cells_);
  // Separable: along each row of the grid, then into all tiles that it counts for. A tile t and its
  // neighbours span the cells (t - 1) n ... (t + 2) n.
  const auto tiles = static_cast<std::size_t>(tile_columns_);
  highest_nearby_.assign(tiles * static_cast<std::size_t>(tile_rows_),
                         -std::numeric_limits<float>::infinity());
  std::vector<float> along_row(tiles);
  for (int row = 0; row < grid_.rows; ++row) {
    const float* line = heights.data() + static_cast<std::size_t>(row) * grid_.columns;
    for (int t = 0; t < tile_columns_; ++t) {
      const int first = std::max(0, (t - 1) * tile_cells_);
      const int last = std::min(grid_.columns - 1, (t + 2) * tile_cells_);
      along_row[static_cast<std::size_t>(t)] = *std::max_element(line + first, line + last + 1);
    }
    const int first_tile = std::max(0, (row + tile_cells_ - 1) / tile_cells_ - 2);
    const int last_tile = std::min(tile_rows_ - 1, row / tile_cells_ + 1);
    for (int t = first_tile; t <= last_tile; ++t) {
      float* highest = highest_nearby_.data() + t * tiles;
      for (std::size_t c = 0; c < tiles; ++c) highest[c] = std::max(highest[c], along_row[c]);
    }
  }
}

}  // namespace dbd
