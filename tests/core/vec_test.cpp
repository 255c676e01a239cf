#include "vec.h"

#include <gtest/gtest.h>

#include "support/core_engine.h"

namespace dbd {
namespace {

const Eigen::Vector3d kA(1, -2, 3), kB(0.5, 4, -1);

TEST(Vec, ProductsAgreeWithEigen) {
  const Vec3<double> a = FromEigen(kA), b = FromEigen(kB);
  EXPECT_EQ(Dot(a, b), kA.dot(kB));
  EXPECT_EQ(ToEigen(Cross(a, b)), kA.cross(kB));
  EXPECT_DOUBLE_EQ(Norm(a), kA.norm());
  EXPECT_LT((ToEigen(Normalized(a)) - kA.normalized()).norm(), 1e-15);
  EXPECT_EQ(ToEigen(a + b), kA + kB);
  EXPECT_EQ(ToEigen(2.0 * a - b), 2 * kA - kB);
}

TEST(Vec, RotationMatrixAndQuaternionProductAgreeWithEigen) {
  const Eigen::Quaterniond p(Eigen::AngleAxisd(0.7, kA.normalized()));
  const Eigen::Quaterniond q(Eigen::AngleAxisd(-1.9, kB.normalized()));
  const Mat3<double> R = RotationMatrix(FromEigen(p));
  EXPECT_LT((ToEigen(R * FromEigen(kB)) - p * kB).norm(), 1e-14);
  EXPECT_LT((ToEigen(R.TransposeTimes(FromEigen(kB))) - p.conjugate() * kB).norm(), 1e-14);
  const Quat<double> pq = FromEigen(p) * FromEigen(q);
  const Eigen::Quaterniond expected = p * q;
  EXPECT_LT((Eigen::Vector4d(pq.x, pq.y, pq.z, pq.w) - expected.coeffs()).norm(), 1e-15);
}

TEST(Vec, ExponentialMapAgreesWithEigenWithinAStep) {
  const Eigen::Quaterniond start(Eigen::AngleAxisd(1.1, kB.normalized()));
  // 0.2 rad is what 50 rad/s turn in 4 ms, the most that the series is meant for.
  for (const double angle : {0.0, 1e-9, 1e-3, 0.05, 0.2}) {
    const Eigen::Vector3d r = angle * kA.normalized();
    const Quat<double> turned = Rotated(FromEigen(start), FromEigen(r));
    const Eigen::Quaterniond expected = Eigen::AngleAxisd(angle, kA.normalized()) * start;
    EXPECT_LT((Eigen::Vector4d(turned.x, turned.y, turned.z, turned.w) - expected.coeffs()).norm(),
              1e-10)
        << angle;
  }
}

TEST(Vec, RotatingBackRestores) {
  const Quat<double> start = FromEigen(Eigen::Quaterniond(Eigen::AngleAxisd(0.4, kA.normalized())));
  const Vec3<double> r{0.05, -0.08, 0.03};
  const Quat<double> back = Rotated(Rotated(start, r), -1.0 * r);
  EXPECT_NEAR(back.w, start.w, 1e-15);
  EXPECT_NEAR(back.x, start.x, 1e-15);
  EXPECT_NEAR(back.y, start.y, 1e-15);
  EXPECT_NEAR(back.z, start.z, 1e-15);
}

}  // namespace
}  // namespace dbd
