#include "trafficability_grid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "row_loop.h"

namespace dbd {
namespace {

// Sums over one row's window, x counted in cells from the window's centre.
struct RowSums {
  double z = 0;
  double xz = 0;
  double zz = 0;
};

void SumRow(const HeightGrid& grid, int row, int k, std::vector<RowSums>* sums) {
  const float* z = &grid.heights[grid.Index(0, row)];
  for (int column = k; column + k < grid.columns; ++column) {
    RowSums sum;
    for (int i = -k; i <= k; ++i) {
      const double height = z[column + i];
      sum.z += height;
      sum.xz += i * height;
      sum.zz += height * height;
    }
    (*sums)[column] = sum;
  }
}

// The 2 k + 1 rows of sums about a row, as a ring.
class RowWindow {
 public:
  // Before the window about row `first`, at least k.
  RowWindow(const HeightGrid& grid, int k, int first)
      : grid_(grid), k_(k), ring_(2 * k + 1, std::vector<RowSums>(grid.columns)) {
    for (int row = first - k; row < first + k; ++row) SumRow(grid, row, k, &Row(row));
  }

  // Takes in the row that the window about `row` needs next.
  void MoveTo(int row) { SumRow(grid_, row + k_, k_, &Row(row + k_)); }

  PlaneFit Fit(int column, int row) const {
    double z = 0, xz = 0, yz = 0, zz = 0;
    for (int j = -k_; j <= k_; ++j) {
      const RowSums& sum = ring_[(row + j) % ring_.size()][column];
      z += sum.z, xz += sum.xz, yz += j * sum.z, zz += sum.zz;
    }
    const double width = 2.0 * k_ + 1.0;
    const double count = width * width;
    const double xx = width * k_ * (k_ + 1.0) * width / 3.0;  // sum of x^2 over the window
    const double residual = zz - z * z / count - (xz * xz + yz * yz) / xx;
    PlaneFit fit;
    fit.grade_x = static_cast<float>(xz / xx / grid_.resolution);
    fit.grade_y = static_cast<float>(yz / xx / grid_.resolution);
    fit.roughness = static_cast<float>(std::sqrt(std::max(0.0, residual) / count));
    return fit;
  }

 private:
  std::vector<RowSums>& Row(int row) { return ring_[row % ring_.size()]; }

  const HeightGrid& grid_;
  int k_;
  std::vector<std::vector<RowSums>> ring_;
};

// Gives cells nearer to the edge than k the fit of the nearest that is not.
void CopyToBorder(const HeightGrid& grid, int k, std::vector<PlaneFit>* fits) {
  for (int row = 0; row < grid.rows; ++row) {
    const int near_row = std::clamp(row, k, grid.rows - 1 - k);
    for (int column = 0; column < grid.columns; ++column) {
      const int near_column = std::clamp(column, k, grid.columns - 1 - k);
      if (near_row == row && near_column == column) continue;
      (*fits)[grid.Index(column, row)] = (*fits)[grid.Index(near_column, near_row)];
    }
  }
}

}  // namespace

HeightGrid SampleHeights(const Terrain& terrain, const Eigen::Vector2d& min_corner, int columns,
                         int rows, double resolution, const std::stop_token& stop) {
  HeightGrid grid{columns, rows, resolution, {}, {}};
  const std::size_t cells = static_cast<std::size_t>(columns) * rows;
  grid.heights.resize(cells);
  grid.known.resize(cells);
  std::vector<double> x(columns);
  for (int i = 0; i < columns; ++i) x[i] = min_corner.x() + i * resolution;
  ForEachRow(0, rows, stop, [&](int row) {
    const std::vector<double> y(columns, min_corner.y() + row * resolution);
    std::vector<double> z(columns);
    terrain.Heights(columns, x.data(), y.data(), z.data());
    for (int i = 0; i < columns; ++i) {
      grid.heights[grid.Index(i, row)] = static_cast<float>(z[i] - terrain.heights().lowest());
      grid.known[grid.Index(i, row)] = terrain.IsKnown(x[i], y[i]) ? 1 : 0;
    }
  });
  return grid;
}

std::vector<PlaneFit> FitPlanes(const HeightGrid& grid, int half_window,
                                const std::stop_token& stop) {
  const int k = half_window;
  std::vector<PlaneFit> fits(grid.heights.size());
  if (grid.columns <= 2 * k || grid.rows <= 2 * k) return fits;
  constexpr int kBand = 64;  // rows; each band sums some rows that its neighbours sum too
  const tbb::blocked_range<int> inner(k, grid.rows - k, kBand);
  tbb::parallel_for(inner, [&](const tbb::blocked_range<int>& band) {
    RowWindow window(grid, k, band.begin());
    for (int row = band.begin(); row < band.end() && !stop.stop_requested(); ++row) {
      window.MoveTo(row);
      for (int column = k; column + k < grid.columns; ++column) {
        fits[grid.Index(column, row)] = window.Fit(column, row);
      }
    }
  });
  ThrowIfStopped(stop);
  CopyToBorder(grid, k, &fits);
  return fits;
}

namespace {

// Marks both ends of the steps along one line of `count` heights, `stride` apart.
void MarkStepsOnLine(const float* z, std::uint8_t* marks, int count, std::size_t stride,
                     double limit) {
  const auto rise = [&](int i) { return double{z[(i + 1) * stride]} - double{z[i * stride]}; };
  for (int i = 0; i + 1 < count; ++i) {
    const double before = i > 0 ? rise(i - 1) : rise(i);
    const double after = i + 2 < count ? rise(i + 1) : rise(i);
    if (std::abs(rise(i) - 0.5 * (before + after)) <= limit) continue;
    marks[i * stride] = 1;
    marks[(i + 1) * stride] = 1;
  }
}

}  // namespace

std::vector<std::uint8_t> FindSteps(const HeightGrid& grid, double limit) {
  std::vector<std::uint8_t> marks(grid.heights.size(), 0);
  tbb::parallel_for(0, grid.rows, [&](int row) {
    const std::size_t start = grid.Index(0, row);
    MarkStepsOnLine(&grid.heights[start], &marks[start], grid.columns, 1, limit);
  });
  tbb::parallel_for(0, grid.columns, [&](int column) {
    MarkStepsOnLine(&grid.heights[column], &marks[column], grid.rows, grid.columns, limit);
  });
  return marks;
}

std::vector<std::uint8_t> Dilate(const std::vector<std::uint8_t>& marks, int columns, int rows,
                                 int half_window, const std::stop_token& stop) {
  std::vector<std::uint8_t> grown(marks.size(), 0);
  for (int row = 0; row < rows; ++row) {
    ThrowIfStopped(stop);
    for (int column = 0; column < columns; ++column) {
      if (!marks[static_cast<std::size_t>(row) * columns + column]) continue;
      const int first = std::max(0, column - half_window);
      const int last = std::min(columns - 1, column + half_window);
      for (int r = std::max(0, row - half_window); r <= std::min(rows - 1, row + half_window);
           ++r) {
        std::fill_n(&grown[static_cast<std::size_t>(r) * columns + first], last - first + 1, 1);
      }
    }
  }
  return grown;
}

}  // namespace dbd
