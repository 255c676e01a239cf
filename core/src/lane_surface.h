#pragma once

#include <dbd/core/ground.h>

#include <array>
#include <optional>
#include <vector>

#include "lane_facets.h"
#include "lane_grid.h"
#include "lane_soils.h"

namespace dbd {

/// The ground under a pack of vehicles, each in coordinates of its own: the world's, less the
/// lane's origin, so that a float is exact to a micrometre anywhere on the map.
template <class Real>
class LaneSurface {
 public:
  static constexpr int kLanes = LaneTraits<Real>::kLanes;
  using S = ScalarOf<Real>;

  explicit LaneSurface(const Ground& ground)
      : ground_(ground), grid_(ground.Grid()), facets_(ground.Facets()) {
    if (facets_) wheel_facets_.resize(kMaxWheels);
    if (grid_) wheel_patches_.resize(kMaxWheels);
    if (const auto soils = ground.SoilClasses()) soils_.emplace(*soils);
    origins_.fill(Eigen::Vector3d::Zero());
    for (int lane = 0; lane < kLanes; ++lane) SetOrigin(lane, Eigen::Vector3d::Zero());
  }

  const Eigen::Vector3d& origin(int lane) const { return origins_[lane]; }
  void SetOrigin(int lane, const Eigen::Vector3d& origin) {
    origins_[lane] = origin;
    if (grid_) lane_grid_.SetOrigin(*grid_, lane, origin);
    for (LaneFacets<Real>& facets : wheel_facets_) facets.Forget(lane);
    for (auto& patch : wheel_patches_) patch.reset();
  }

  void Heights(int count, const Real* x, const Real* y, Real* z) const {
    if (grid_) {
      for (int i = 0; i < count; ++i) z[i] = lane_grid_.Height(*grid_, x[i], y[i]);
      return;
    }
    for (int i = 0; i < count; ++i) z[i] = AskForHeight(x[i], y[i]);
  }

  void HighestWithin(double radius, int count, const Real* x, const Real* y, Real* z) const {
    const bool one_read = grid_ && radius <= grid_->tile_width;
    for (int i = 0; i < count; ++i) {
      z[i] = one_read ? lane_grid_.HighestNearby(*grid_, x[i], y[i])
                      : AskGround(x[i], y[i], [&](const double* wx, const double* wy, double* wz) {
                          ground_.HighestWithin(radius, kLanes, wx, wy, wz);
                        });
    }
  }

  /// The cells that hold everything within `radius` of each lane's place, if four do; else null.
  /// `wheel`: whose place it is; its cells are kept until it is on others in any lane, which takes
  /// a vehicle some dozens of steps.
  const LanePatch<Real>* Patch(std::size_t wheel, double radius, const Real& x,
                               const Real& y) const {
    if (!grid_ || !LaneGrid<Real>::CellsHold(*grid_, radius)) return nullptr;
    std::optional<LanePatch<Real>>& patch = wheel_patches_[wheel];
    const Real column = lane_grid_.NearestColumn(x), row = lane_grid_.NearestRow(y);
    if (!patch || !patch->IsAround(column, row)) patch = lane_grid_.Patch(*grid_, column, row);
    return &*patch;
  }

  /// Heights around a wheel, on triangles.
  struct FacetPatch {
    void Heights(int count, const Real* x, const Real* y, Real* z) const {
      for (int i = 0; i < count; ++i) {
        z[i] = facets.LowestAt(x[i], y[i]);
        const auto unknown = z[i] > Real(LaneFacets<Real>::kNoHeight);
        if (AnyOf(unknown)) z[i] = Select(unknown, surface.AskForHeight(x[i], y[i]), z[i]);
      }
    }

    const LaneSurface& surface;
    const LaneFacets<Real>& facets;
    GroundPlane<Real> plane;  // that they are nowhere above
  };

  /// Those within `radius` of each lane's place, if triangles are so large that they are few.
  /// `wheel`: whose place it is; its triangles are remembered.
  std::optional<FacetPatch> Facets(std::size_t wheel, double radius, const Real& x,
                                   const Real& y) const {
    if (!facets_ || radius > facets_->bin_size) return std::nullopt;
    LaneFacets<Real>& lanes = wheel_facets_[wheel];
    lanes.Update(x, y, [&](int lane, FacetsNear* near, LinearFunction<double>* bound) {
      FindFacets(radius, lane, x.v[lane], y.v[lane], near, bound);
    });
    return FacetPatch{*this, lanes, lanes.Plane(x, y)};
  }

  /// Nothing where the ground must be asked for all that there is to know of its soils.
  std::optional<PlainSoils<Real>> Plain(const Real& x, const Real& y) const {
    if (!soils_ || !soils_->plain()) return std::nullopt;
    double wx[kLanes], wy[kLanes];
    ToWorld(x, y, wx, wy);
    return soils_->At(wx, wy);
  }

  /// kLanes soils for each of `count` packs of places.
  void Soils(int count, const Real* x, const Real* y, SoilSample* soil) const {
    for (int i = 0; i < count; ++i) {
      double wx[kLanes], wy[kLanes];
      ToWorld(x[i], y[i], wx, wy);
      ground_.Soils(kLanes, wx, wy, soil + i * kLanes);
    }
  }

 private:
  void ToWorld(const Real& x, const Real& y, double* wx, double* wy) const {
    S lx[kLanes], ly[kLanes];
    LaneTraits<Real>::Store(x, lx);
    LaneTraits<Real>::Store(y, ly);
    for (int i = 0; i < kLanes; ++i) {
      wx[i] = origins_[i].x() + static_cast<double>(lx[i]);
      wy[i] = origins_[i].y() + static_cast<double>(ly[i]);
    }
  }

  void FindFacets(double radius, int lane, S x, S y, FacetsNear* near,
                  LinearFunction<double>* bound) const {
    const Eigen::Vector3d& origin = origins_[lane];
    const double wx = origin.x() + static_cast<double>(x), wy = origin.y() + static_cast<double>(y);
    const double reach = LaneFacets<Real>::Reach(radius);
    FindFacetsNear(*facets_, reach, wx, wy, near);
    const double base_height = facets_->base_height - origin.z();
    for (int i = 0; i < near->count; ++i) near->facets[i].height.c += base_height;
    *bound = near->bound;
    bound->c += base_height;
    if (near->whole) return;
    *bound = {};
    ground_.HighestWithin(reach, 1, &wx, &wy, &bound->c);
    bound->c -= origin.z();
  }

  Real AskForHeight(const Real& x, const Real& y) const {
    return AskGround(x, y, [this](const double* wx, const double* wy, double* wz) {
      ground_.Heights(kLanes, wx, wy, wz);
    });
  }

  template <class Query>
  Real AskGround(const Real& x, const Real& y, const Query& query) const {
    double wx[kLanes], wy[kLanes], wz[kLanes];
    ToWorld(x, y, wx, wy);
    query(wx, wy, wz);
    S lz[kLanes];
    for (int i = 0; i < kLanes; ++i) lz[i] = static_cast<S>(wz[i] - origins_[i].z());
    return LaneTraits<Real>::Load(lz);
  }

  const Ground& ground_;
  std::optional<GroundGrid> grid_;
  std::optional<GroundFacets> facets_;
  std::optional<LaneSoils<Real>> soils_;
  std::array<Eigen::Vector3d, kLanes> origins_;
  LaneGrid<Real> lane_grid_;
  // A surface belongs to one pack.
  mutable std::vector<LaneFacets<Real>> wheel_facets_;
  mutable std::vector<std::optional<LanePatch<Real>>> wheel_patches_;
};

}  // namespace dbd
