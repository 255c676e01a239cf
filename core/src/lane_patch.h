#pragma once

#include <array>

#include "ground_plane.h"

namespace dbd {

/// Heights of 3 x 3 nodes, rows northwards, columns eastwards.
template <class Real>
using PatchNodes = std::array<std::array<Real, 3>, 3>;

/// One axis of a patch, in cells.
template <class Real>
struct PatchAxis {
  Real offset;
  Real per_metre;
  Real node;  // the middle one
};

/// The four cells around a node of a raster, for each lane: where cells are wider than a tire, its
/// whole print lies on them, and the nodes are read once for all its points. Heights are those that
/// the raster itself gives, to the last bit, as they must be for a lane not to depend on whether
/// its neighbours are at the raster's edge.
template <class Real>
class LanePatch {
 public:
  using S = ScalarOf<Real>;

  LanePatch(const PatchAxis<Real>& x, const PatchAxis<Real>& y, const PatchNodes<Real>& nodes,
            const Real& base_height)
      : x_(x), y_(y), nodes_(nodes), base_height_(base_height) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 2; ++i) rises_[j][i] = nodes[j][i + 1] - nodes[j][i];
    }
  }

  void Heights(int count, const Real* x, const Real* y, Real* z) const {
    for (int i = 0; i < count; ++i) z[i] = Height(x[i], y[i]);
  }

  /// A plane above the cells: their mean slope, lifted over the highest of the nodes. Ground less
  /// plane is bilinear in every cell, so that no place between nodes is higher.
  GroundPlane<Real> Plane(const Real& x, const Real& y) const {
    const PatchNodes<Real>& h = nodes_;
    const Real sixth{S(1.0 / 6)};
    const Real rise_x = sixth * ((h[0][2] + h[1][2] + h[2][2]) - (h[0][0] + h[1][0] + h[2][0]));
    const Real rise_y = sixth * ((h[2][0] + h[2][1] + h[2][2]) - (h[0][0] + h[0][1] + h[0][2]));
    Real level = h[1][1];
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        level = Max(level, h[j][i] - Real(S(i - 1)) * rise_x - Real(S(j - 1)) * rise_y);
      }
    }
    const Real here = base_height_ + level + FromNode(x_, x) * rise_x + FromNode(y_, y) * rise_y;
    return {here, rise_x * x_.per_metre, rise_y * y_.per_metre};
  }

 private:
  /// In cells.
  static Real FromNode(const PatchAxis<Real>& axis, const Real& x) {
    return x * axis.per_metre + axis.offset - axis.node;
  }

  Real Height(const Real& x, const Real& y) const {
    const Real u = x * x_.per_metre + x_.offset, v = y * y_.per_metre + y_.offset;
    const auto west = u < x_.node, south = v < y_.node;
    const Real one(1);
    const Real east_part = u - Select(west, x_.node - one, x_.node);
    const Real north_part = v - Select(south, y_.node - one, y_.node);
    std::array<Real, 3> row;
    for (int j = 0; j < 3; ++j) {
      row[j] = Select(west, nodes_[j][0], nodes_[j][1]) +
               east_part * Select(west, rises_[j][0], rises_[j][1]);
    }
    const Real south_z = Select(south, row[0], row[1]), north_z = Select(south, row[1], row[2]);
    return base_height_ + (south_z + north_part * (north_z - south_z));
  }

  PatchAxis<Real> x_, y_;
  PatchNodes<Real> nodes_;
  std::array<std::array<Real, 2>, 3> rises_;  // eastwards
  Real base_height_;
};

}  // namespace dbd
