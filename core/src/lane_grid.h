#pragma once

#include <dbd/core/ground_grid.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "corner_columns.h"
#include "lane_patch.h"
#include "pack.h"

namespace dbd {

/// Height look-ups of a pack of places in a grid, each in its lane's own coordinates: whole cells
/// from the grid's corner to the lane's origin are integers, so that only the way from there is
/// rounded.
template <class Real>
class LaneGrid {
 public:
  static constexpr int kLanes = LaneTraits<Real>::kLanes;
  using S = ScalarOf<Real>;
  using Integers = typename Real::Integers;

  void SetOrigin(const GroundGrid& grid, int lane, const Eigen::Vector3d& origin) {
    SetAxis(origin.x() - grid.x0, grid.cell_x, grid.columns, lane, x_);
    SetAxis(origin.y() - grid.y0, grid.cell_y, grid.rows, lane, y_);
    corner_[lane] = y_.first[lane] * static_cast<LaneInteger<S>>(grid.columns) + x_.first[lane];
    base_height_.v[lane] = static_cast<S>(grid.base_height - origin.z());
  }

  Real Height(const GroundGrid& grid, const Real& x, const Real& y) const {
    const Cell east = Locate(x_, x), north = Locate(y_, y);
    const Integers index = north.whole * static_cast<LaneInteger<S>>(grid.columns) + east.whole;
    const Corners c = ReadCorners(grid.row_pairs, index + corner_);
    const Real south_z = c.south_west + east.part * (c.south_east - c.south_west);
    const Real north_z = c.north_west + east.part * (c.north_east - c.north_west);
    return base_height_ + (south_z + north.part * (north_z - south_z));
  }

  /// Whether a circle of this radius stays within half a cell of its centre: then the four cells
  /// around the node that is nearest to the centre hold it.
  static bool CellsHold(const GroundGrid& grid, double radius) {
    return std::min(grid.columns, grid.rows) > 2 &&
           radius < 0.5 * std::min(grid.cell_x, grid.cell_y);
  }

  Real NearestColumn(const Real& x) const { return NearestNode(x_, x); }
  Real NearestRow(const Real& y) const { return NearestNode(y_, y); }

  /// Those four cells, around a node.
  LanePatch<Real> Patch(const GroundGrid& grid, const Real& column, const Real& row) const {
    return LanePatch<Real>({x_.offset, x_.per_metre, column}, {y_.offset, y_.per_metre, row},
                           ReadNodes(grid, column, row), base_height_);
  }

  Real HighestNearby(const GroundGrid& grid, const Real& x, const Real& y) const {
    const Integers index =
        TileOf(grid, y_, y) * static_cast<LaneInteger<S>>(grid.tile_columns) + TileOf(grid, x_, x);
    S highest[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      highest[i] = static_cast<S>(grid.highest_nearby[index[i]]);
    }
    return base_height_ + LaneTraits<Real>::Load(highest);
  }

 private:
  /// One axis of the grid seen from the lanes' origins, in cells.
  struct Axis {
    Integers first{};   // a cell before the origin, by more than a vehicle goes from there
    Real offset{S(0)};  // from there to the origin
    Real most{S(0)};    // of the grid's far end
    Real per_metre{S(1)};
    Real last_node{S(1)};
  };
  struct Cell {
    Integers whole;  // from `first`
    Real part;
  };
  struct ColumnsOfDoubles {
    Real south_west, north_west, south_east, north_east;
  };
  using Corners =
      std::conditional_t<std::is_same_v<S, float>, CornerColumns<kLanes>, ColumnsOfDoubles>;

  static void SetAxis(double from_corner, double cell, int count, int lane, Axis& axis) {
    constexpr double kReach = 16;  // [m] from a lane's origin
    const double place = from_corner / cell;
    const double first =
        std::clamp(std::floor(place - kReach / cell), 0.0, std::max(0.0, count - 2.0));
    axis.first[lane] = static_cast<LaneInteger<S>>(first);
    axis.offset.v[lane] = static_cast<S>(place - first);
    // Just below the last row of cells, so that whole numbers stay inside the grid.
    axis.most.v[lane] = std::nextafter(static_cast<S>(count - 1 - first), S(0));
    axis.per_metre.v[lane] = static_cast<S>(1 / cell);
    axis.last_node.v[lane] = static_cast<S>(count - 1 - first);
  }

  static Cell Locate(const Axis& axis, const Real& x) {
    const Real u = Min(Max(x * axis.per_metre + axis.offset, Real(S(0))), axis.most);
    const Integers whole = __builtin_convertvector(u.v, Integers);
    return {whole, u - Real(__builtin_convertvector(whole, typename Real::Vector))};
  }

  /// A whole number, from `first`, whose cell a vehicle does not reach unless it is the grid's own.
  static Real NearestNode(const Axis& axis, const Real& x) {
    const Real u = x * axis.per_metre + axis.offset + Real(S(0.5));
    const Real inside = Min(Max(u, Real(S(0))), axis.last_node);
    const Integers whole = __builtin_convertvector(inside.v, Integers);
    return Real(__builtin_convertvector(whole, typename Real::Vector));
  }

  /// At the grid's edge the outer nodes are as high as the edge: heights go on level.
  PatchNodes<Real> ReadNodes(const GroundGrid& grid, const Real& column, const Real& row) const {
    const Real zero{S(0)}, one{S(1)};
    const auto columns = static_cast<LaneInteger<S>>(grid.columns);
    const Real west_column = Max(column - one, zero), east_column = Min(column, x_.last_node - one);
    const Real south_row = Max(row - one, zero), north_row = Min(row, y_.last_node - one);
    const Integers west = __builtin_convertvector(west_column.v, Integers);
    const Integers east = __builtin_convertvector(east_column.v, Integers);
    const Integers south = __builtin_convertvector(south_row.v, Integers) * columns + corner_;
    const Integers north = __builtin_convertvector(north_row.v, Integers) * columns + corner_;
    const Corners sw = ReadCorners(grid.row_pairs, south + west);
    const Corners se = ReadCorners(grid.row_pairs, south + east);
    const Corners nw = ReadCorners(grid.row_pairs, north + west);
    const Corners ne = ReadCorners(grid.row_pairs, north + east);
    const auto westmost = column < one, southmost = row < one;
    const auto middle = [&](const Real& a, const Real& b) { return Select(westmost, a, b); };
    const Real south_z = middle(sw.south_west, sw.south_east);
    const Real middle_z = middle(sw.north_west, sw.north_east);
    return {{{sw.south_west, south_z, se.south_east},
             {Select(southmost, sw.south_west, sw.north_west), Select(southmost, south_z, middle_z),
              Select(southmost, se.south_east, se.north_east)},
             {nw.north_west, middle(nw.north_west, nw.north_east), ne.north_east}}};
  }

  /// Whole tiles before the cell: a product with the reciprocal, half a cell away from the edges
  /// where it could round wrongly (vectors have no division of integers).
  static Integers TileOf(const GroundGrid& grid, const Axis& axis, const Real& x) {
    const auto cell =
        __builtin_convertvector(Locate(axis, x).whole + axis.first, typename Real::Vector);
    return __builtin_convertvector((cell + S(0.5)) * S(1.0 / grid.tile_cells), Integers);
  }

  static Corners ReadCorners(const float* pairs, const Integers& index) {
    if constexpr (std::is_same_v<S, float>) {
      return ReadCornerColumns<kLanes>(pairs, index);
    } else {
      Corners c;
      for (int i = 0; i < kLanes; ++i) {
        const float* corner = pairs + 2 * static_cast<std::int64_t>(index[i]);
        c.south_west.v[i] = corner[0];
        c.north_west.v[i] = corner[1];
        c.south_east.v[i] = corner[2];
        c.north_east.v[i] = corner[3];
      }
      return c;
    }
  }

  Axis x_, y_;
  Integers corner_{};  // index of the cell at both axes' `first`
  Real base_height_{S(0)};
};

}  // namespace dbd
