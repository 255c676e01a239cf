#pragma once

#include <Eigen/Core>

#include "scalar.h"

namespace dbd {

// Small vectors over any `Real`. Eigen serves the public interface and the set-up; these serve the
// hot loop, where the element may be a pack of lanes.

template <class Real>
struct Vec3 {
  Real x, y, z;

  Vec3& operator+=(const Vec3& b) {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  Vec3& operator-=(const Vec3& b) {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
};

template <class Real>
Vec3<Real> operator+(Vec3<Real> a, const Vec3<Real>& b) {
  return a += b;
}
template <class Real>
Vec3<Real> operator-(Vec3<Real> a, const Vec3<Real>& b) {
  return a -= b;
}
template <class Real>
Vec3<Real> operator*(const std::type_identity_t<Real>& s, const Vec3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
Real Dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vec3<Real> Cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Real Norm(const Vec3<Real>& a) {
  return Sqrt(Dot(a, a));
}
template <class Real>
Vec3<Real> Normalized(const Vec3<Real>& a) {
  return (Real(1) / Norm(a)) * a;
}

template <class Mask, class Real>
Vec3<Real> Select(const Mask& mask, const Vec3<Real>& yes, const Vec3<Real>& no) {
  return {Select(mask, yes.x, no.x), Select(mask, yes.y, no.y), Select(mask, yes.z, no.z)};
}

/// The same constant vector in every lane.
template <class Real>
Vec3<Real> Broadcast(const Eigen::Vector3d& v) {
  using S = ScalarOf<Real>;
  return {Real(S(v.x())), Real(S(v.y())), Real(S(v.z()))};
}

/// A vector of the model that has numbers of its own for each lane already.
template <class Real>
const Vec3<Real>& Broadcast(const Vec3<Real>& v) {
  return v;
}

/// The model's own numbers, of the type that lanes compute with.
template <class Real, std::floating_point Number>
requires(!std::is_same_v<Real, Number>) Vec3<Real> Broadcast(const Vec3<Number>& v) {
  return {ToLanes<Real>(v.x), ToLanes<Real>(v.y), ToLanes<Real>(v.z)};
}

/// Columns are the axes of a frame: R_WB = {x_W, y_W, z_W} of B.
template <class Real>
struct Mat3 {
  Vec3<Real> x, y, z;

  Vec3<Real> operator*(const Vec3<Real>& v) const {
    return {v.x * x.x + v.y * y.x + v.z * z.x, v.x * x.y + v.y * y.y + v.z * z.y,
            v.x * x.z + v.y * y.z + v.z * z.z};
  }
  Vec3<Real> TransposeTimes(const Vec3<Real>& v) const { return {Dot(x, v), Dot(y, v), Dot(z, v)}; }
};

template <class Real>
struct Quat {
  Real w, x, y, z;
};

template <class Real>
Quat<Real> operator*(const Quat<Real>& a, const Quat<Real>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

template <class Real>
Mat3<Real> RotationMatrix(const Quat<Real>& q) {
  const Real xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Real xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const Real wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const Real one(1), two(2);
  return {{one - two * (yy + zz), two * (xy + wz), two * (xz - wy)},
          {two * (xy - wz), one - two * (xx + zz), two * (yz + wx)},
          {two * (xz + wy), two * (yz - wx), one - two * (xx + yy)}};
}

/// q turned by the rotation vector `r` given in W. The half angles of one step are small (below
/// 0.1 rad at 50 rad/s and 4 ms), so that series to the sixth order are exact to round-off.
template <class Real>
Quat<Real> Turned(const Quat<Real>& q, const Vec3<Real>& r) {
  using S = ScalarOf<Real>;
  const auto c = [](double value) { return Real(S(value)); };
  const Real h2 = c(0.25) * Dot(r, r);
  const Real cosine = c(1) - h2 * (c(1.0 / 2) - h2 * (c(1.0 / 24) - h2 * c(1.0 / 720)));
  const Real sinc = c(0.5) * (c(1) - h2 * (c(1.0 / 6) - h2 * c(1.0 / 120)));
  return Quat<Real>{cosine, sinc * r.x, sinc * r.y, sinc * r.z} * q;
}

/// The same, again and again: of length one to round-off. So near to one, 1/sqrt(n) is
/// 1 - (n - 1)/2, whose error is the square of what there is to correct.
template <class Real>
Quat<Real> Rotated(const Quat<Real>& q, const Vec3<Real>& r) {
  using S = ScalarOf<Real>;
  const Quat<Real> t = Turned(q, r);
  const Real norm2 = t.w * t.w + t.x * t.x + t.y * t.y + t.z * t.z;
  const Real scale = Real(S(1.5)) - Real(S(0.5)) * norm2;
  return {scale * t.w, scale * t.x, scale * t.y, scale * t.z};
}

}  // namespace dbd
