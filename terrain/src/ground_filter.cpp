#include "ground_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

// Calls `visit` with every known height within `reach` cells.
template <typename Visit>
void ForNeighbours(const HeightGrid& grid, int column, int row, int reach, Visit visit) {
  for (int r = std::max(0, row - reach); r <= std::min(grid.rows - 1, row + reach); ++r) {
    for (int c = std::max(0, column - reach); c <= std::min(grid.columns - 1, column + reach);
         ++c) {
      if (!std::isnan(grid.At(c, r))) visit(grid.At(c, r));
    }
  }
}

template <typename Compute>
HeightGrid Map(const HeightGrid& grid, Compute compute) {
  HeightGrid result = grid;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      result.At(column, row) = compute(column, row);
    }
  }
  return result;
}

// Least (or greatest, by `less`) known height within `reach` cells along one axis.
template <typename Less>
HeightGrid AlongAxis(const HeightGrid& grid, int reach, bool along_rows, Less less) {
  return Map(grid, [&](int column, int row) {
    float best = kUnknown;
    const int at = along_rows ? column : row;
    const int last = std::min((along_rows ? grid.columns : grid.rows) - 1, at + reach);
    for (int i = std::max(0, at - reach); i <= last; ++i) {
      const float height = along_rows ? grid.At(i, row) : grid.At(column, i);
      if (std::isnan(best) || less(height, best)) best = height;
    }
    return best;
  });
}

HeightGrid Open(const HeightGrid& grid, int reach) {
  HeightGrid low = AlongAxis(grid, reach, true, std::less<>());
  low = AlongAxis(low, reach, false, std::less<>());
  HeightGrid opened = AlongAxis(low, reach, true, std::greater<>());
  return AlongAxis(opened, reach, false, std::greater<>());
}

}  // namespace

void RemovePits(float drop, HeightGrid* grid) {
  std::vector<float> around;
  *grid = Map(*grid, [&](int column, int row) {
    const float height = grid->At(column, row);
    if (std::isnan(height)) return kUnknown;
    around.clear();
    ForNeighbours(*grid, column, row, 2, [&](float h) { around.push_back(h); });
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    return height < *middle - drop ? kUnknown : height;
  });
}

void RemoveWhatStands(double step, double slope, double widest, HeightGrid* grid) {
  for (int reach = 1; reach * grid->cell_size <= widest; reach *= 2) {
    const HeightGrid opened = Open(*grid, reach);
    const auto limit = static_cast<float>(step + slope * reach * grid->cell_size);
    for (std::size_t i = 0; i < grid->heights.size(); ++i) {
      if (grid->heights[i] > opened.heights[i] + limit) grid->heights[i] = kUnknown;
    }
  }
}

void SmoothAndBridge(int reach, HeightGrid* grid) {
  *grid = Map(*grid, [&](int column, int row) {
    float sum = 0;
    int count = 0;
    ForNeighbours(*grid, column, row, reach, [&](float h) {
      sum += h;
      ++count;
    });
    // Outside what was seen, fewer than half of the cells around are known.
    const bool is_between = !std::isnan(grid->At(column, row)) || 2 * count >= (2 * reach + 1);
    return count > 0 && is_between ? sum / static_cast<float>(count) : kUnknown;
  });
}

}  // namespace dbd
