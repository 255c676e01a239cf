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
/// whole print lies on them, and the nodes are read once for all its points.
///
/// With e and n the ways from the middle node in cells, split in their positive and negative
/// parts, the four bilinear pieces are one polynomial: no lane asks in which cell it is.
template <class Real>
class LanePatch {
 public:
  using S = ScalarOf<Real>;

  LanePatch(const PatchAxis<Real>& x, const PatchAxis<Real>& y, const PatchNodes<Real>& h,
            const Real& base_height)
      : x_(x),
        y_(y),
        middle_(h[1][1] + base_height),
        east_(h[1][2] - h[1][1]),
        west_(h[1][1] - h[1][0]),
        north_(h[2][1] - h[1][1]),
        south_(h[1][1] - h[0][1]),
        north_east_((h[2][2] - h[2][1]) - east_),
        north_west_((h[2][1] - h[2][0]) - west_),
        south_east_(east_ - (h[0][2] - h[0][1])),
        south_west_(west_ - (h[0][1] - h[0][0])) {
    SetPlane(h, base_height);
  }

  /// Whether it lies around this node, in every lane.
  bool IsAround(const Real& column, const Real& row) const {
    return !AnyOf(Max(Abs(column - x_.node), Abs(row - y_.node)) > Real(S(0)));
  }

  void Heights(int count, const Real* x, const Real* y, Real* z) const {
    for (int i = 0; i < count; ++i) z[i] = Height(x[i], y[i]);
  }

  /// A plane above the cells: their mean slope, lifted over the highest of the nodes. Ground less
  /// plane is bilinear in every cell, so that no place between nodes is higher. Level for a place
  /// beyond the raster's edge, where the ground is.
  GroundPlane<Real> Plane(const Real& x, const Real& y) const {
    const Real e = FromNode(x_, x), n = FromNode(y_, y);
    const auto outside = Max(Abs(e), Abs(n)) > Real(S(0.501));
    const Real zero(0);
    const Real highest = level_ + Abs(rise_x_) + Abs(rise_y_);
    return {Select(outside, highest, level_ + e * rise_x_ + n * rise_y_),
            Select(outside, zero, rise_x_ * x_.per_metre),
            Select(outside, zero, rise_y_ * y_.per_metre)};
  }

 private:
  void SetPlane(const PatchNodes<Real>& h, const Real& base_height) {
    const Real sixth{S(1.0 / 6)};
    rise_x_ = sixth * ((h[0][2] + h[1][2] + h[2][2]) - (h[0][0] + h[1][0] + h[2][0]));
    rise_y_ = sixth * ((h[2][0] + h[2][1] + h[2][2]) - (h[0][0] + h[0][1] + h[0][2]));
    const auto above = [](const Real& west, const Real& between, const Real& east,
                          const Real& rise) { return Max(Max(west + rise, between), east - rise); };
    const Real middle = above(h[1][0], h[1][1], h[1][2], rise_x_);
    const Real south = above(h[0][0], h[0][1], h[0][2], rise_x_);
    const Real north = above(h[2][0], h[2][1], h[2][2], rise_x_);
    level_ = base_height + above(south, middle, north, rise_y_);
  }

  /// In cells.
  static Real FromNode(const PatchAxis<Real>& axis, const Real& x) {
    return x * axis.per_metre + axis.offset - axis.node;
  }

  Real Height(const Real& x, const Real& y) const {
    const Real zero(0);
    const Real e = FromNode(x_, x), n = FromNode(y_, y);
    const Real east = Max(e, zero), west = Min(e, zero);
    const Real north = Max(n, zero), south = Min(n, zero);
    return middle_ + (north * north_ + south * south_) +
           (east * (east_ + north * north_east_ + south * south_east_) +
            west * (west_ + north * north_west_ + south * south_west_));
  }

  PatchAxis<Real> x_, y_;
  Real middle_, east_, west_, north_, south_;               // height and rises per cell
  Real north_east_, north_west_, south_east_, south_west_;  // how the rises change
  Real level_{S(0)}, rise_x_{S(0)}, rise_y_{S(0)};          // of the plane
};

}  // namespace dbd
