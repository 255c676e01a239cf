#pragma once

#include <algorithm>
#include <array>
#include <numbers>

#include "facet_search.h"
#include "ground_plane.h"
#include "lane_state.h"

namespace dbd {

/// The triangles around one wheel of each lane. They are found once for all points of a tire, and
/// again when the wheel has moved on. What lies in one lane does not depend on the others: a place
/// is looked up among its own lane's triangles, and where it is on none of them the ground itself
/// is asked.
template <class Real>
class LaneFacets {
 public:
  static constexpr int kLanes = LaneTraits<Real>::kLanes;
  using S = ScalarOf<Real>;

  /// How far places on the triangles may be from the wheel when those within `radius` are wanted,
  /// and looked for where it was last.
  static double Reach(double radius) { return radius + std::numbers::sqrt2 * kKeptFor; }

  /// As if nothing was known of this lane.
  void Forget(int lane) { x_.v[lane] = kNowhere; }

  /// Calls find(lane, &near, &bound) for lanes that are not where they were. Heights there are from
  /// the lane's origin; `bound` is a plane that the ground is nowhere above.
  template <class Find>
  void Update(const Real& x, const Real& y, const Find& find) {
    const auto moved = Max(Abs(x - x_), Abs(y - y_)) > Real(S(kKeptFor));
    if (!AnyOf(moved)) return;
    const Real is_moved = Select(moved, Real(S(1)), Real(S(0)));
    FacetsNear near;
    LinearFunction<double> bound;
    for (int lane = 0; lane < kLanes; ++lane) {
      if (is_moved.v[lane] == 0) continue;
      x_.v[lane] = x.v[lane];
      y_.v[lane] = y.v[lane];
      find(lane, &near, &bound);
      SetLane(lane, near, bound);
    }
    count_ = *std::max_element(counts_.begin(), counts_.end());
  }

  /// kNoHeight or more where a place is on no triangle.
  Real LowestAt(const Real& x, const Real& y) const {
    Real lowest(kNowhere);
    for (int i = 0; i < count_; ++i) {
      const Facet<Real>& facet = facets_[i];
      const Real inside =
          Min(Min(At(facet.edges[0], x, y), At(facet.edges[1], x, y)), At(facet.edges[2], x, y));
      const Real height = Min(lowest, At(facet.height, x, y));
      lowest = Select(inside < Real(S(-kFacetSeam)), lowest, height);
    }
    return lowest;
  }
  static constexpr S kNoHeight{1e29F};

  GroundPlane<Real> Plane(const Real& x, const Real& y) const {
    return {At(bound_, x, y), bound_.a, bound_.b};
  }

 private:
  static constexpr double kKeptFor = 0.1;  // [m] along each axis
  static constexpr S kNowhere{1e30F};

  Real At(const LinearFunction<Real>& f, const Real& x, const Real& y) const {
    return f.a * (x - x_) + f.b * (y - y_) + f.c;
  }

  void SetLane(int lane, const FacetsNear& near, const LinearFunction<double>& bound) {
    constexpr LinearFunction<double> kOutside{0, 0, -1};
    constexpr Facet<double> kNoFacet{{kOutside, kOutside, kOutside}, {}};
    SetLaneOf(bound_, lane, bound);
    for (int i = 0; i < near.count; ++i) SetLaneOf(facets_[i], lane, near.facets[i]);
    for (int i = near.count; i < kMostFacetsNear; ++i) SetLaneOf(facets_[i], lane, kNoFacet);
    counts_[lane] = near.count;
  }

  Real x_{kNowhere}, y_{kNowhere};
  LinearFunction<Real> bound_;
  int count_ = 0;
  std::array<int, kLanes> counts_{};
  std::array<Facet<Real>, kMostFacetsNear> facets_;
};

}  // namespace dbd
