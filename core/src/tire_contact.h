#pragma once

#include <dbd/core/ground.h>

#include <array>
#include <numbers>

#include "engine_state.h"
#include "soil_rule.h"

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

inline constexpr int kTirePlanes = 3;
inline constexpr int kMaxLowerPoints = 33;  // of one plane, for 64 points round the circle

/// The lower points of one plane in the tire frame (x rolling direction, z up, origin at the hub)
/// and what is constant between neighbours.
struct TirePattern {
  double radius = 0;
  double half_span = 0;  // lateral distance of the outer planes from the middle one
  double width = 0;      // of the tire
  double stiffness = 0;
  int count = 0;  // odd; the middle point is the lowest
  std::array<double, kMaxLowerPoints> x{};
  std::array<double, kMaxLowerPoints> z{};
  // Of the segment from point i to i+1: four times the sagitta of the circle below its chord, and
  // quotients that the sums need.
  std::array<double, kMaxLowerPoints> bulge{};
  std::array<double, kMaxLowerPoints> half_by_bulge{};
  std::array<double, kMaxLowerPoints> length{};
  std::array<double, kMaxLowerPoints> by_length{};
};

inline TirePattern MakeTirePattern(const TireModel& tire) {
  TirePattern pattern;
  pattern.radius = tire.radius;
  pattern.half_span = tire.width / kTirePlanes;
  pattern.width = tire.width;
  pattern.stiffness = tire.stiffness;
  const double step = 2 * std::numbers::pi / tire.points;
  const int half = static_cast<int>(std::floor((0.5 * std::numbers::pi - 1e-9) / step));
  pattern.count = 2 * half + 1;
  for (int i = 0; i < pattern.count; ++i) {
    pattern.x[i] = tire.radius * std::sin((i - half) * step);
    pattern.z[i] = -tire.radius * std::cos((i - half) * step);
  }
  for (int i = 0; i + 1 < pattern.count; ++i) {
    const double mid_x = 0.5 * (pattern.x[i] + pattern.x[i + 1]);
    const double chord = 0.5 * (pattern.z[i] + pattern.z[i + 1]);
    const double circle = -std::sqrt(tire.radius * tire.radius - mid_x * mid_x);
    pattern.bulge[i] = 4 * (chord - circle);
    pattern.half_by_bulge[i] = 0.5 / pattern.bulge[i];
    pattern.length[i] = pattern.x[i + 1] - pattern.x[i];
    pattern.by_length[i] = 1 / pattern.length[i];
  }
  return pattern;
}

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
  Real area{0}, x{0}, y{0}, z{0}, slope_x{0}, slope_y{0};
};

/// Penetrations, and ground heights in the tire frame, at one angle in the three planes.
template <class Real>
struct PointRow {
  std::array<Real, kTirePlanes> penetration;
  std::array<Real, kTirePlanes> ground;
  Real slope_y;
};

/// Adds segment `i` of plane `j`: penetration p(t) = p0 + b t - q t^2 for t in [0, 1], counted
/// where it is positive.
template <class Real>
void AddSegment(const TirePattern& pattern, int i, int j, const PointRow<Real>& here,
                const PointRow<Real>& next, ContactSums<Real>& sums) {
  using S = ScalarOf<Real>;
  const Real p0 = here.penetration[j];
  const Real q{S(pattern.bulge[i])};
  const Real b = next.penetration[j] - p0 + q;
  const Real disc = b * b + Real(4) * q * p0;
  if (!AnyOf(disc > Real(0))) return;
  const Real root = Sqrt(Max(disc, Real(0)));
  const Real scale{S(pattern.half_by_bulge[i])};
  const Real t0 = Clamp((b - root) * scale, Real(0), Real(1));
  const Real t1 = Clamp((b + root) * scale, Real(0), Real(1));
  if (!AnyOf(t1 > t0)) return;
  const auto primitive = [&](const Real& t) {
    return t * (p0 + t * (Real(S(0.5)) * b - t * q * Real(S(1.0 / 3))));
  };
  const Real length{S(pattern.length[i])};
  const Real area = length * Max(primitive(t1) - primitive(t0), Real(0));
  const Real t = Real(S(0.5)) * (t0 + t1);
  const Real rise = next.ground[j] - here.ground[j];
  sums.area = sums.area + area;
  sums.x = sums.x + area * (Real(S(pattern.x[i])) + t * length);
  sums.y = sums.y + area * Real(S((j - 1) * pattern.half_span));
  sums.z = sums.z + area * (here.ground[j] + t * rise);
  sums.slope_x = sums.slope_x + area * rise * Real(S(pattern.by_length[i]));
  sums.slope_y = sums.slope_y + area * Real(S(0.5)) * (here.slope_y + next.slope_y);
}

/// From vertical penetrations to the tire frame. A ground point lies above or below its tire point
/// by the vertical penetration p; seen in the tire frame it is p z_t.z higher and p y_t.z further
/// left, and the slope across the planes brings it back over the tire point.
template <class Real>
PointRow<Real> ToTireFrame(const std::array<Real, kTirePlanes>& vertical, const Mat3<Real>& R_WT,
                           double half_span, double z) {
  using S = ScalarOf<Real>;
  const Real rise = vertical[2] - vertical[0];
  PointRow<Real> row;
  row.slope_y = rise * R_WT.z.z / (Real(S(2 * half_span)) + rise * R_WT.y.z);
  const Real factor = R_WT.z.z - row.slope_y * R_WT.y.z;
  for (int j = 0; j < kTirePlanes; ++j) {
    row.penetration[j] = vertical[j] * factor;
    row.ground[j] = Real(S(z)) + row.penetration[j];
  }
  return row;
}

/// How many points on each side of the lowest one can touch ground that is nowhere higher than
/// `highest`; -1 = none. The next point outwards belongs to it, for the segment in between.
template <class Real>
int ActiveHalfCount(const TirePattern& pattern, const Mat3<Real>& R_WT, const Vec3<Real>& p_WH,
                    const Real& highest) {
  using S = ScalarOf<Real>;
  const Real lowest_hub = p_WH.z - Real(S(pattern.half_span)) * Abs(R_WT.y.z) - highest;
  const double reach = static_cast<double>(LeastLane(lowest_hub / R_WT.z.z));
  const int half = pattern.count / 2;
  constexpr double kBulgeMargin = 1.01;  // the circle lies up to 0.6 % below its points' chords
  int active = -1;
  while (active < half && -pattern.z[half + active + 1] * kBulgeMargin >= reach) ++active;
  return active < 0 ? -1 : std::min(active + 1, half);
}

/// Heights under the points half-count .. half+count of all planes, as vertical penetrations.
template <class Real>
void VerticalPenetrations(const TirePattern& pattern, const Ground& ground, const Mat3<Real>& R_WT,
                          const Vec3<Real>& p_WH, int first, int last,
                          std::array<std::array<Real, kTirePlanes>, kMaxLowerPoints>& result) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  constexpr int kMost = kMaxLowerPoints * kTirePlanes * kLanes;
  S x[kMost], y[kMost], z[kMost];
  Real tire_z[kMaxLowerPoints * kTirePlanes];
  int n = 0;
  for (int i = first; i <= last; ++i) {
    const Vec3<Real> middle =
        p_WH + Real(S(pattern.x[i])) * R_WT.x + Real(S(pattern.z[i])) * R_WT.z;
    for (int j = 0; j < kTirePlanes; ++j, ++n) {
      const Vec3<Real> p = middle + Real(S((j - 1) * pattern.half_span)) * R_WT.y;
      LaneTraits<Real>::Store(p.x, x + n * kLanes);
      LaneTraits<Real>::Store(p.y, y + n * kLanes);
      tire_z[n] = p.z;
    }
  }
  ground.Heights(n * kLanes, x, y, z);
  n = 0;
  for (int i = first; i <= last; ++i) {
    for (int j = 0; j < kTirePlanes; ++j, ++n) {
      result[i][j] = LaneTraits<Real>::Load(z + n * kLanes) - tire_z[n];
    }
  }
}

/// Deflection of a tire on flat ground that displaces the same area: A = (4/3) sqrt(2R) d^1.5
/// (1 - 3d/20R), inverted.
template <class Real>
Real EquivalentDeflection(const Real& area, double radius) {
  using S = ScalarOf<Real>;
  const Real scaled = area * Real(S(0.75 / (std::numbers::sqrt2 * radius * radius)));
  const Real root = Cbrt(scaled);
  const Real ratio = root * root;
  return Real(S(radius)) * ratio * (Real(1) + Real(S(0.1)) * ratio);
}

template <class Real>
void SetContactSoil(const TirePattern& pattern, const Ground& ground, TireContact<Real>& contact) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  S x[kLanes], y[kLanes], cone_index[kLanes], friction[kLanes];
  SoilSample soil[kLanes];
  LaneTraits<Real>::Store(contact.p_WH.x + contact.p_HC_W.x, x);
  LaneTraits<Real>::Store(contact.p_WH.y + contact.p_HC_W.y, y);
  ground.Soils(kLanes, x, y, soil);
  for (int i = 0; i < kLanes; ++i) {
    cone_index[i] = static_cast<S>(soil[i].cone_index);
    friction[i] = static_cast<S>(soil[i].friction_limit);
  }
  contact.cone_index = LaneTraits<Real>::Load(cone_index);
  contact.friction_limit = LaneTraits<Real>::Load(friction);
  contact.rule = MakeSoilRule(soil, {pattern.width, 2 * pattern.radius, pattern.stiffness},
                              contact.deflection);
}

template <class Real>
Real HighestUnder(const Ground& ground, double radius, const Vec3<Real>& p_WH) {
  using S = ScalarOf<Real>;
  constexpr int kLanes = LaneTraits<Real>::kLanes;
  S x[kLanes], y[kLanes], z[kLanes];
  LaneTraits<Real>::Store(p_WH.x, x);
  LaneTraits<Real>::Store(p_WH.y, y);
  ground.HighestWithin(radius, kLanes, x, y, z);
  return LaneTraits<Real>::Load(z);
}

template <class Real>
ContactSums<Real> SumContact(const TirePattern& pattern, const Ground& ground,
                             const Mat3<Real>& R_WT, const Vec3<Real>& p_WH, int active) {
  const int half = pattern.count / 2;
  std::array<std::array<Real, kTirePlanes>, kMaxLowerPoints> vertical;
  VerticalPenetrations(pattern, ground, R_WT, p_WH, half - active, half + active, vertical);
  const auto row_at = [&](int i) {
    return ToTireFrame(vertical[i], R_WT, pattern.half_span, pattern.z[i]);
  };
  ContactSums<Real> sums;
  PointRow<Real> here = row_at(half - active);
  for (int i = half - active; i < half + active; ++i) {
    const PointRow<Real> next = row_at(i + 1);
    for (int j = 0; j < kTirePlanes; ++j) AddSegment(pattern, i, j, here, next, sums);
    here = next;
  }
  return sums;
}

/// Samples the ground under a wheel whose hub is at p_WH with spin axis y_W (left).
template <class Real>
void SampleContact(const TirePattern& pattern, const Ground& ground, const Vec3<Real>& p_WH,
                   const Vec3<Real>& y_W, TireContact<Real>& contact) {
  using S = ScalarOf<Real>;
  const Mat3<Real> R_WT = TireFrame(y_W);
  contact.p_WH = p_WH;
  contact.deflection = Real(0);
  const Real highest = HighestUnder(ground, pattern.radius + pattern.half_span, p_WH);
  const int active = ActiveHalfCount(pattern, R_WT, p_WH, highest);
  if (active < 0) return;

  const ContactSums<Real> sums = SumContact(pattern, ground, R_WT, p_WH, active);
  const Real least_area{S(1e-12)};
  const Real scale = Real(1) / Max(sums.area, least_area);
  contact.normal_W =
      Normalized(R_WT.z - (scale * sums.slope_x) * R_WT.x - (scale * sums.slope_y) * R_WT.y);
  contact.p_HC_W = R_WT * Vec3<Real>{scale * sums.x, scale * sums.y, scale * sums.z};
  contact.deflection =
      Select(sums.area > least_area,
             EquivalentDeflection(Real(S(1.0 / kTirePlanes)) * sums.area, pattern.radius), Real(0));
  SetContactSoil(pattern, ground, contact);
}

}  // namespace dbd
