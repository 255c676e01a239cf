#pragma once

#include <dbd/core/ground.h>

#include "counted.h"

namespace dbd {

/// What `LaneSurface` and `LaneGrid` do for packs over a grid of small cells, counted.
template <int N>
class CountedSurface {
 public:
  using Real = Counted<N>;

  /// `ground` is a grid and must outlive it.
  explicit CountedSurface(const Ground& ground) : ground_(ground), grid_(*ground.Grid()) {}

  void Heights(int count, const Real* x, const Real* y, Real* z) const {
    for (int i = 0; i < count; ++i) z[i] = Height(x[i], y[i]);
  }

  void HighestWithin(double, int count, const Real* x, const Real* y, Real* z) const {
    for (int i = 0; i < count; ++i) z[i] = HighestNearby(x[i], y[i]);
  }

  void Soils(int count, const Real* x, const Real* y, SoilSample* soil) const {
    for (int i = 0; i < count; ++i) {
      OperationTally::Count(Operation::kSoilRead);
      ground_.Soils(N, x[i].v.data(), y[i].v.data(), soil + i * N);
    }
  }

 private:
  struct Cell {
    Real whole, part;
  };

  Cell Locate(const Real& x, double first, double cell, int count) const {
    const Real cells = x * Real(1 / cell) + Real(-first / cell);
    const Real u = Min(Max(cells, Real(0)), Real(std::nextafter(count - 1.0, 0.0)));
    const Real whole = Truncated(u);
    return {whole, u - whole};
  }
  Cell East(const Real& x) const { return Locate(x, grid_.x0, grid_.cell_x, grid_.columns); }
  Cell North(const Real& y) const { return Locate(y, grid_.y0, grid_.cell_y, grid_.rows); }

  Real Height(const Real& x, const Real& y) const {
    const Cell east = East(x), north = North(y);
    OperationTally::Count(Operation::kHeightRead);
    Real corner[4];
    for (int i = 0; i < N; ++i) {
      const auto index = static_cast<std::ptrdiff_t>(north.whole.v[i]) * grid_.columns +
                         static_cast<std::ptrdiff_t>(east.whole.v[i]);
      for (int k = 0; k < 4; ++k) corner[k].v[i] = grid_.row_pairs[2 * index + k];
    }
    const Real south_z = corner[0] + east.part * (corner[2] - corner[0]);
    const Real north_z = corner[1] + east.part * (corner[3] - corner[1]);
    return Real(grid_.base_height) + (south_z + north.part * (north_z - south_z));
  }

  Real HighestNearby(const Real& x, const Real& y) const {
    const Cell east = East(x), north = North(y);
    OperationTally::Count(Operation::kBoundRead);
    Real highest;
    for (int i = 0; i < N; ++i) {
      const auto row = static_cast<std::ptrdiff_t>(north.whole.v[i]) / grid_.tile_cells;
      const auto column = static_cast<std::ptrdiff_t>(east.whole.v[i]) / grid_.tile_cells;
      highest.v[i] = grid_.highest_nearby[row * grid_.tile_columns + column];
    }
    return Real(grid_.base_height) + highest;
  }

  const Ground& ground_;
  GroundGrid grid_;
};

}  // namespace dbd
