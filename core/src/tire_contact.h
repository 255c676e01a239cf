#pragma once

#include <dbd/core/ground.h>

#include <array>
#include <numbers>

#include "engine_state.h"
#include "ground_plane.h"
#include "soil_rule.h"
#include "tire_pattern.h"

namespace dbd {

// Where and how deep a tire stands in the ground (paper section 4.5): three circumferential planes
// of sampled points, the volume between tire and ground by integration, the direction of the normal
// force from the shape of the ground under the contact.
//
// The planes stay upright: they follow camber and steering, never the wheel's rotation, so that the
// result does not depend on the phase of the points. Between neighbouring points the ground is
// taken as straight and the tire as the parabola through its circle; the area where the tire is
// below the ground then has a closed form, exact to third order, with entry and exit found inside
// the segment. Known difference: points above the hub are left out. They cannot touch a height
// field before the lower half is buried.

/// Upright axes of a tire: forward and up, perpendicular to the spin axis `y`.
template <class Real>
Mat3<Real> TireFrame(const Vec3<Real>& y) {
  const Real scale = Real(1) / Sqrt(y.x * y.x + y.y * y.y);
  const Vec3<Real> x{scale * y.y, Real(-1) * scale * y.x, Real(0)};
  return {x, y, Cross(x, y)};
}

/// Sums over the contact, weighted with the area between tire and ground.
template <class Real>
struct ContactSums {
  std::array<Real, kTirePlanes> area{Real(0), Real(0), Real(0)};  // of each plane
  Real x{0}, z{0}, slope_x{0}, slope_y{0};
};

/// One row of points, at the same angle in the three planes: how deep each is below the ground,
/// seen in the tire frame, and the slope of the ground across the planes.
template <class Real>
struct PointRow {
  std::array<Real, kTirePlanes> penetration;
  Real slope_y;
};

/// What a segment adds to the sums of all planes, before its own constants come in.
template <class Real>
struct SegmentSums {
  Real area{0}, along{0}, height{0}, rise{0};  // area times 1, t, ground above the tire point, rise
};

/// Adds plane `j` of the segment that begins at `point`: penetration p(t) = p0 + b t - q t^2 for t
/// in [0, 1], counted where it is positive.
template <class Real, class Number>
void AddSegment(const TirePoint<Number>& point, int j, const PointRow<Real>& here,
                const PointRow<Real>& next, SegmentSums<Real>& row, ContactSums<Real>& sums) {
  using S = ScalarOf<Real>;
  const Real p0 = here.penetration[j];
  const Real change = next.penetration[j] - p0;
  const Real b = change + ToLanes<Real>(point.bulge);
  const Real disc = b * b + ToLanes<Real>(point.four_bulge) * p0;
  const Real root = Sqrt(Max(disc, Real(0)));
  const Real scale = ToLanes<Real>(point.half_by_bulge);
  const Real t0 = Clamp((b - root) * scale, Real(0), Real(1));
  const Real t1 = Clamp((b + root) * scale, Real(0), Real(1));
  const Real both = t0 + t1;
  const Real half_b = Real(S(0.5)) * b, third_q = ToLanes<Real>(point.third_bulge);
  const Real mean = p0 + half_b * both - third_q * (both * both - t0 * t1);
  const Real area = ToLanes<Real>(point.length) * Max((t1 - t0) * mean, Real(0));
  const Real t = Real(S(0.5)) * both;
  const Real rise = ToLanes<Real>(point.rise) + change;
  sums.area[j] = sums.area[j] + area;
  row.area = row.area + area;
  row.along = row.along + area * t;
  row.height = row.height + area * (p0 + t * rise);
  row.rise = row.rise + area * rise;
}

/// Adds the segment between two rows, all planes.
template <class Real, class Number>
void AddSegments(const TirePoint<Number>& point, const PointRow<Real>& here,
                 const PointRow<Real>& next, ContactSums<Real>& sums) {
  using S = ScalarOf<Real>;
  SegmentSums<Real> row;
  for (int j = 0; j < kTirePlanes; ++j) AddSegment(point, j, here, next, row, sums);
  sums.x = sums.x + ToLanes<Real>(point.x) * row.area + ToLanes<Real>(point.length) * row.along;
  sums.z = sums.z + ToLanes<Real>(point.z) * row.area + row.height;
  sums.slope_x = sums.slope_x + ToLanes<Real>(point.by_length) * row.rise;
  sums.slope_y = sums.slope_y + row.area * (Real(S(0.5)) * (here.slope_y + next.slope_y));
}

/// From vertical penetrations to the tire frame. A ground point lies above or below its tire point
/// by the vertical penetration p; seen in the tire frame it is p z_t.z higher and p y_t.z further
/// left, and the slope across the planes brings it back over the tire point.
template <class Real, class Number>
PointRow<Real> ToTireFrame(const std::array<Real, kTirePlanes>& vertical, const Mat3<Real>& R_WT,
                           const Number& span) {
  const Real rise = vertical[2] - vertical[0];
  PointRow<Real> row;
  row.slope_y = rise * R_WT.z.z / (ToLanes<Real>(span) + rise * R_WT.y.z);
  const Real factor = R_WT.z.z - row.slope_y * R_WT.y.z;
  for (int j = 0; j < kTirePlanes; ++j) row.penetration[j] = vertical[j] * factor;
  return row;
}

/// Rows of points, `last` included; none where `last` is less than `first`.
struct RowRange {
  int first = 0;
  int last = -1;
};

/// The rows that can touch ground which is nowhere above the plane `bound`, in any lane, and one
/// more to each side for the segments in between.
template <class Real, class Pattern>
RowRange ActiveRows(const Pattern& pattern, const Mat3<Real>& R_WT, const Vec3<Real>& p_WH,
                    const GroundPlane<Real>& bound) {
  using S = ScalarOf<Real>;
  constexpr double kBulgeMargin = 1.01;  // the circle lies up to 0.6 % below its points' chords
  const Vec3<Real> up{Real(-1) * bound.slope_x, Real(-1) * bound.slope_y, Real(1)};
  const Real hub =
      p_WH.z - bound.height - ToLanes<Real>(pattern.size.half_span) * Abs(Dot(up, R_WT.y));
  const Real along = Real(S(kBulgeMargin)) * Dot(up, R_WT.x);
  const Real upward = Real(S(kBulgeMargin)) * Dot(up, R_WT.z);
  const auto touches = [&](int i) {
    const Real height = hub + ToLanes<Real>(pattern.points[i].x) * along +
                        ToLanes<Real>(pattern.points[i].z) * upward;
    return AnyOf(height < Real(0));
  };
  const int end = pattern.count - 1;
  RowRange rows{0, end};
  while (rows.first <= end && !touches(rows.first)) ++rows.first;
  if (rows.first > end) return {};
  while (!touches(rows.last)) --rows.last;
  return {std::max(rows.first - 1, 0), std::min(rows.last + 1, end)};
}

/// Rows whose heights are asked for together: one question for a whole wheel, and row by row in
/// packs, which look the heights up themselves and need not keep them.
template <class Real>
inline constexpr int kRowsAtOnce = LaneTraits<Real>::kLanes == 1 ? kMaxLowerPoints : 1;

/// Writes `count` rows of points from `first` on.
template <class Real, class Pattern, class Surface>
void MeasureRows(const Pattern& pattern, const Surface& ground, const Mat3<Real>& R_WT,
                 const Vec3<Real>& p_WH, int first, int count, PointRow<Real>* rows) {
  constexpr int kMost = kRowsAtOnce<Real> * kTirePlanes;
  Real x[kMost], y[kMost], z[kMost], tire_z[kMost];
  const Vec3<Real> across = ToLanes<Real>(pattern.size.half_span) * R_WT.y;
  const std::array<Vec3<Real>, kTirePlanes> centers = {p_WH - across, p_WH, p_WH + across};
  for (int i = 0; i < count; ++i) {
    const auto& point = pattern.points[first + i];
    const Vec3<Real> down = ToLanes<Real>(point.x) * R_WT.x + ToLanes<Real>(point.z) * R_WT.z;
    for (int j = 0; j < kTirePlanes; ++j) {
      x[i * kTirePlanes + j] = centers[j].x + down.x;
      y[i * kTirePlanes + j] = centers[j].y + down.y;
      tire_z[i * kTirePlanes + j] = centers[j].z + down.z;
    }
  }
  ground.Heights(count * kTirePlanes, x, y, z);
  for (int i = 0; i < count; ++i) {
    std::array<Real, kTirePlanes> vertical;
    for (int j = 0; j < kTirePlanes; ++j) {
      vertical[j] = z[i * kTirePlanes + j] - tire_z[i * kTirePlanes + j];
    }
    rows[i] = ToTireFrame(vertical, R_WT, pattern.size.span);
  }
}

/// Without the rows at both ends that no part of a segment between them touches the ground beside:
/// what they would add is nothing, in every lane.
template <class Real, class Pattern>
RowRange TouchingRows(const Pattern& pattern, const PointRow<Real>* rows, RowRange range) {
  const auto touches = [&](int i) {
    // A segment's parabola rises by at most a sagitta above the deeper of its ends.
    const auto &a = rows[i].penetration, &b = rows[i + 1].penetration;
    const Real deepest = Max(Max(Max(a[0], a[1]), a[2]), Max(Max(b[0], b[1]), b[2]));
    return AnyOf(deepest + ToLanes<Real>(pattern.points[i].bulge) > Real(0));
  };
  while (range.first < range.last && !touches(range.first)) ++range.first;
  while (range.first < range.last && !touches(range.last - 1)) --range.last;
  return range;
}

template <class Real, class Pattern, class Surface>
ContactSums<Real> SumContact(const Pattern& pattern, const Surface& ground, const Mat3<Real>& R_WT,
                             const Vec3<Real>& p_WH, const RowRange& range) {
  std::array<PointRow<Real>, kMaxLowerPoints> rows;
  for (int i = range.first; i <= range.last; i += kRowsAtOnce<Real>) {
    const int count = std::min(kRowsAtOnce<Real>, range.last - i + 1);
    MeasureRows(pattern, ground, R_WT, p_WH, i, count, &rows[i]);
  }
  ContactSums<Real> sums;
  const RowRange touching = TouchingRows(pattern, rows.data(), range);
  for (int i = touching.first; i < touching.last; ++i) {
    AddSegments(pattern.points[i], rows[i], rows[i + 1], sums);
  }
  return sums;
}

/// Deflection of a tire on flat ground that displaces the same area: A = (4/3) sqrt(2R) d^1.5
/// (1 - 3d/20R), inverted.
template <class Real, class Number>
Real EquivalentDeflection(const Real& area, const TireSizes<Number>& tire) {
  using S = ScalarOf<Real>;
  const Real scaled = area * ToLanes<Real>(tire.by_flat_area);
  const Real root = Cbrt(scaled);
  const Real ratio = root * root;
  return ToLanes<Real>(tire.radius) * ratio * (Real(1) + Real(S(0.1)) * ratio);
}

/// Everything that the ground knows of the soil at one place per lane.
template <class Real, class Surface, class Sizes>
void AskForSoil(const Surface& ground, const Real& x, const Real& y, const Sizes& tire,
                TireContact<Real>& contact) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  S cone_index[kLanes], friction[kLanes];
  SoilSample soil[kLanes];
  ground.Soils(1, &x, &y, soil);
  for (int i = 0; i < kLanes; ++i) {
    cone_index[i] = static_cast<S>(soil[i].cone_index);
    friction[i] = static_cast<S>(soil[i].friction_limit);
  }
  contact.cone_index = LaneTraits<Real>::Load(cone_index);
  contact.friction_limit = LaneTraits<Real>::Load(friction);
  contact.rule = MakeSoilRule(soil, tire, contact.deflection);
}

/// In the lanes that touch the ground.
template <class Real, class Pattern, class Surface, class Mask>
void SetContactSoil(const Pattern& pattern, const Surface& ground, const Mask& touching,
                    TireContact<Real>& contact) {
  const Real x = contact.p_WH.x + contact.p_HC_W.x, y = contact.p_WH.y + contact.p_HC_W.y;
  const auto set = [&](const Real& value, Real& kept) { kept = Select(touching, value, kept); };
  if constexpr (requires { ground.Plain(x, y); }) {
    if (const auto soil = ground.Plain(x, y)) {
      set(soil->cone_index, contact.cone_index);
      set(soil->friction_limit, contact.friction_limit);
      set(soil->traction_model, contact.rule.model);
      return;
    }
  }
  TireContact<Real> met = contact;
  AskForSoil(ground, x, y, pattern.size, met);
  set(met.cone_index, contact.cone_index);
  set(met.friction_limit, contact.friction_limit);
  set(met.rule.model, contact.rule.model);
  set(met.rule.capacity, contact.rule.capacity);
  set(met.rule.shear_rate, contact.rule.shear_rate);
  set(met.rule.resistance, contact.rule.resistance);
}

/// `shape` gives heights no higher than the plane `bound`, `ground` the soil under them.
template <class Real, class Pattern, class Shape, class Surface>
void SampleContactOn(const Pattern& pattern, const Shape& shape, const GroundPlane<Real>& bound,
                     const Surface& ground, const Mat3<Real>& R_WT, TireContact<Real>& contact) {
  using S = ScalarOf<Real>;
  const RowRange rows = ActiveRows(pattern, R_WT, contact.p_WH, bound);
  if (rows.last < rows.first) return;

  const ContactSums<Real> sums = SumContact(pattern, shape, R_WT, contact.p_WH, rows);
  const Real least_area{S(1e-12)};
  const Real area = sums.area[0] + sums.area[1] + sums.area[2];
  const auto touching = area > least_area;
  if (!AnyOf(touching)) return;
  // A lane in the air keeps what it last met, as it would alone.
  const Real scale = Real(1) / Max(area, least_area);
  contact.normal_W =
      Select(touching,
             Normalized(R_WT.z - (scale * sums.slope_x) * R_WT.x - (scale * sums.slope_y) * R_WT.y),
             contact.normal_W);
  const Real y = ToLanes<Real>(pattern.size.half_span) * (sums.area[2] - sums.area[0]);
  contact.p_HC_W = Select(touching, R_WT * Vec3<Real>{scale * sums.x, scale * y, scale * sums.z},
                          contact.p_HC_W);
  const Real mean_area = Real(S(1.0 / kTirePlanes)) * area;
  contact.deflection = Select(touching, EquivalentDeflection(mean_area, pattern.size), Real(0));
  SetContactSoil(pattern, ground, touching, contact);
}

/// Samples the ground under a wheel whose hub is at p_WH with spin axis y_W (left). Some grounds
/// remember what lay around each `wheel`.
template <class Real, class Pattern, class Surface>
void SampleContact(const Pattern& pattern, const Surface& ground, const Vec3<Real>& p_WH,
                   const Vec3<Real>& y_W, TireContact<Real>& contact, std::size_t wheel = 0) {
  const Mat3<Real> R_WT = TireFrame(y_W);
  contact.p_WH = p_WH;
  contact.deflection = Real(0);
  if constexpr (requires { ground.Patch(wheel, pattern.reach, p_WH.x, p_WH.y); }) {
    if (const auto* patch = ground.Patch(wheel, pattern.reach, p_WH.x, p_WH.y)) {
      SampleContactOn(pattern, *patch, patch->Plane(p_WH.x, p_WH.y), ground, R_WT, contact);
      return;
    }
  }
  if constexpr (requires { ground.Facets(wheel, pattern.reach, p_WH.x, p_WH.y); }) {
    if (const auto facets = ground.Facets(wheel, pattern.reach, p_WH.x, p_WH.y)) {
      SampleContactOn(pattern, *facets, facets->plane, ground, R_WT, contact);
      return;
    }
  }
  SampleContactOn(pattern, ground, LevelBound(ground, pattern.reach, p_WH), ground, R_WT, contact);
}

}  // namespace dbd
