#pragma once

#include <dbd/core/ground.h>

#include <algorithm>
#include <array>

#include "pack.h"

namespace dbd {

/// Soils under a pack of places whose traction needs no plate constants.
template <class Real>
struct PlainSoils {
  Real cone_index;
  Real friction_limit;
  Real traction_model;
};

/// A ground's soils as the numbers that lanes compute with, by class.
template <class Real>
class LaneSoils {
 public:
  static constexpr int kLanes = LaneTraits<Real>::kLanes;
  using S = ScalarOf<Real>;

  explicit LaneSoils(const GroundSoils& soils) : raster_(soils) {
    for (int i = 0; i < soils.count; ++i) {
      const SoilSample& soil = soils.soils[i];
      cone_index_[i] = static_cast<S>(soil.cone_index);
      friction_limit_[i] = static_cast<S>(soil.friction_limit);
      traction_model_[i] = static_cast<S>(soil.traction_model);
      plain_ = plain_ && soil.traction_model != TractionModel::kBekker;
    }
  }

  /// Whether none of them needs plate constants.
  bool plain() const { return plain_; }

  /// `x`, `y`: in W, one for each lane. Only where all soils are plain.
  PlainSoils<Real> At(const double* x, const double* y) const {
    if (raster_.classes == nullptr) {
      return {Real(cone_index_[0]), Real(friction_limit_[0]), Real(traction_model_[0])};
    }
    S cone_index[kLanes], friction_limit[kLanes], traction_model[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      const std::uint8_t soil = ClassAt(x[i], y[i]);
      cone_index[i] = cone_index_[soil];
      friction_limit[i] = friction_limit_[soil];
      traction_model[i] = traction_model_[soil];
    }
    using Lanes = LaneTraits<Real>;
    return {Lanes::Load(cone_index), Lanes::Load(friction_limit), Lanes::Load(traction_model)};
  }

 private:
  std::uint8_t ClassAt(double x, double y) const {
    const std::ptrdiff_t cell = raster_.grid.CellAt(x, y);
    return cell < 0 ? raster_.outside : raster_.classes[cell];
  }

  GroundSoils raster_;
  bool plain_ = true;
  std::array<S, 256> cone_index_{}, friction_limit_{}, traction_model_{};
};

}  // namespace dbd
