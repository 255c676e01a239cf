#include "tire_contact.h"

#include <dbd/core/scenario.h>
#include <dbd/core/units.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_ground.h"

namespace dbd {
namespace {

TireModel RearTire(int points = 30) {
  TireModel tire;
  tire.radius = 0.3302;
  tire.width = 0.3048;
  tire.points = points;
  return tire;
}
constexpr double kRadius = 0.3302;

TireContact<double> Sample(const Ground& ground, const Eigen::Vector3d& hub,
                           const Eigen::Vector3d& axis = Eigen::Vector3d::UnitY(),
                           int points = 30) {
  TireContact<double> contact{};
  SampleContact(MakeTirePattern(RearTire(points)), ground, FromEigen(hub), FromEigen(axis),
                contact);
  return contact;
}

/// A plane that falls at `angle` in the direction `azimuth`, and a wheel that stands on it in the
/// plane's own attitude, its hub `height` above it.
struct WheelOnPlane {
  WheelOnPlane(double angle, double azimuth) {
    const Eigen::AngleAxisd tilt(angle, Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0));
    normal = tilt * Eigen::Vector3d::UnitZ();
    ground = MakePlaneGround(-normal.x() / normal.z(), -normal.y() / normal.z());
    // The spin axis lies in the plane; heading along x as seen from above.
    axis = (Eigen::Vector3d::UnitY() - normal.y() * normal).normalized();
  }
  TireContact<double> At(double height, const Eigen::Vector3d& offset = {0, 0, 0}) const {
    return Sample(*ground, hub(height, offset), axis);
  }
  Eigen::Vector3d hub(double height, const Eigen::Vector3d& offset) const {
    return height * normal + offset - offset.dot(normal) * normal;
  }

  Eigen::Vector3d normal, axis;
  std::shared_ptr<const Ground> ground;
};

TEST(TireContact, FlatGroundDeflectionAtAnyHeight) {
  const auto ground = MakePlaneGround(0, 0);
  for (double deflection = 0.5e-3; deflection < 0.06; deflection *= 1.13) {
    const auto contact = Sample(*ground, {0, 0, kRadius - deflection});
    // The parabola between points stands for the circle: 0.9 % at half a millimetre.
    EXPECT_NEAR(contact.deflection / deflection, 1, deflection < 1e-3 ? 0.01 : 0.005);
    EXPECT_LT((ToEigen(contact.normal_W) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(contact.p_HC_W.x, 0, 1e-12);
    EXPECT_NEAR(contact.p_HC_W.y, 0, 1e-12);
    EXPECT_NEAR(contact.p_HC_W.z, deflection - kRadius, 1e-12);
  }
}

TEST(TireContact, TiltedPlaneDeflectionNormalAndPoint) {
  // Sweeping the slope moves the contact past the sampled points: there must be no phase effect.
  for (double angle = -30; angle <= 30; angle += 0.75) {
    for (const double azimuth : {0.0, 30.0, 90.0}) {
      const WheelOnPlane wheel(Degrees(angle), Degrees(azimuth));
      for (const double deflection : {3e-3, 9.5e-3, 25e-3}) {
        const auto contact = wheel.At(kRadius - deflection);
        const auto at = ::testing::Message() << angle << " " << azimuth << " " << deflection;
        EXPECT_NEAR(contact.deflection / deflection, 1, 0.005) << at;
        EXPECT_LT((ToEigen(contact.normal_W) - wheel.normal).norm(), 1e-9) << at;
        const Eigen::Vector3d point =
            wheel.hub(kRadius - deflection, {0, 0, 0}) + ToEigen(contact.p_HC_W);
        EXPECT_NEAR(point.dot(wheel.normal), 0, 1e-9) << at;
        EXPECT_LT(point.norm(), 0.02 * kRadius) << at;  // under the hub
      }
    }
  }
}

TEST(TireContact, MovingAlongTheGroundChangesNothing) {
  const WheelOnPlane wheel(Degrees(12), Degrees(50));
  const double expected = wheel.At(kRadius - 0.008).deflection;
  for (double s = -1; s < 1; s += 0.037) {
    EXPECT_NEAR(wheel.At(kRadius - 0.008, {s, 0.3 * s, 0}).deflection, expected, 1e-9);
  }
}

TEST(TireContact, CamberAveragesTheThreePlanes) {
  // A wheel leaning by g to the side: plane j at the lateral place y = -w/3, 0, w/3 is R - h/cos g
  // + y tan g deep; the deflection is that of the mean area, A ~ d^1.5 (1 - 3 d / 20 R).
  const auto ground = MakePlaneGround(0, 0);
  const auto area = [](double d) {
    return d <= 0 ? 0 : std::pow(d, 1.5) * (1 - 0.15 * d / kRadius);
  };
  for (double camber = -20; camber <= 20; camber += 2.5) {
    const double g = Degrees(camber);
    const Eigen::Vector3d axis(0, std::cos(g), -std::sin(g));
    const double height = kRadius - 0.02;
    double mean = 0;
    for (const double y : {-0.1016, 0.0, 0.1016}) {
      mean += area(kRadius - height / std::cos(g) + y * std::tan(g)) / 3;
    }
    const auto contact = Sample(*ground, {0, 0, height}, axis);
    EXPECT_NEAR(area(contact.deflection), mean, 0.01 * mean) << camber;
    EXPECT_LT((ToEigen(contact.normal_W) - Eigen::Vector3d::UnitZ()).norm(), 1e-9) << camber;
    EXPECT_NEAR(height + contact.p_HC_W.z, 0, 1e-9) << camber;
    // Seen along the spin axis, towards the side that leans down.
    EXPECT_GE(ToEigen(contact.p_HC_W).dot(axis) * camber, 0) << camber;
  }
}

TEST(TireContact, CamberOnASideSlopeKeepsTheNormal) {
  for (const double slope : {-20.0, 10.0, 25.0}) {
    for (const double camber : {-15.0, 5.0, 20.0}) {
      const WheelOnPlane wheel(Degrees(slope), 0);
      const Eigen::Vector3d axis =
          Eigen::AngleAxisd(Degrees(camber), Eigen::Vector3d::UnitX()) * wheel.axis;
      const Eigen::Vector3d hub = wheel.hub(kRadius - 0.02, {0, 0, 0});
      const auto contact = Sample(*wheel.ground, hub, axis);
      ASSERT_GT(contact.deflection, 0);
      EXPECT_LT((ToEigen(contact.normal_W) - wheel.normal).norm(), 1e-9);
      EXPECT_NEAR((hub + ToEigen(contact.p_HC_W)).dot(wheel.normal), 0, 1e-9);
    }
  }
}

TEST(TireContact, NothingTouchesFromAbove) {
  const auto flat = MakePlaneGround(0, 0);
  EXPECT_EQ(Sample(*flat, {0, 0, kRadius + 1e-6}).deflection, 0);
  EXPECT_EQ(Sample(*flat, {0, 0, 5}).deflection, 0);
  const auto bump = MakeBumpGround(1, 0.1);
  EXPECT_EQ(Sample(*bump, {1, 0, kRadius + 0.1001}).deflection, 0);
  EXPECT_GT(Sample(*bump, {1, 0, kRadius + 0.09}).deflection, 0);
}

TEST(TireContact, DeflectionGrowsContinuouslyFromTheFirstTouch) {
  const auto ground = MakePlaneGround(0, 0);
  double last = 0;
  for (double depth = -1e-4; depth < 2e-3; depth += 1e-5) {
    const double deflection = Sample(*ground, {0, 0, kRadius - depth}).deflection;
    EXPECT_GE(deflection, last);
    EXPECT_LT(deflection - last, 2.5e-5);
    last = deflection;
  }
}

TEST(TireContact, HalfCylinderIsSymmetricInFrontAndBehind) {
  const auto bump = MakeBumpGround(0, 0.1);
  for (double s = 0.005; s < 0.42; s += 0.013) {
    const auto before = Sample(*bump, {-s, 0, 0.325}), behind = Sample(*bump, {s, 0, 0.325});
    EXPECT_NEAR(before.deflection, behind.deflection, 1e-9) << s;
    EXPECT_NEAR(before.normal_W.x, -behind.normal_W.x, 1e-9) << s;
    EXPECT_NEAR(before.normal_W.z, behind.normal_W.z, 1e-9) << s;
  }
}

TEST(TireContact, ObstacleAheadPushesBack) {
  const auto bump = MakeBumpGround(0, 0.1);
  const auto contact = Sample(*bump, {-0.25, 0, kRadius - 0.005});
  EXPECT_LT(contact.normal_W.x, 0);
  EXPECT_GT(contact.p_HC_W.x, 0);
}

TEST(TireContact, MorePointsConverge) {
  // A crest of 0.5 m radius, against the finest sampling that is allowed.
  const FunctionGround crest([](double x, double) { return -x * x; });
  const auto deflection = [&](int points) {
    return Sample(crest, {0.1, 0, kRadius}, Eigen::Vector3d::UnitY(), points).deflection;
  };
  const double fine = deflection(64);
  EXPECT_NEAR(deflection(12), fine, 0.10 * fine);
  EXPECT_NEAR(deflection(30), fine, 0.03 * fine);
  EXPECT_NEAR(deflection(48), fine, 0.02 * fine);
}

TEST(TireContact, FlatGroundIsExactForAnyNumberOfPoints) {
  const auto ground = MakePlaneGround(0.1, -0.05);
  for (int points = 12; points <= 64; ++points) {
    const Eigen::Vector3d normal = Eigen::Vector3d(-0.1, 0.05, 1).normalized();
    const auto contact = Sample(*ground, (kRadius - 0.01) * normal,
                                Eigen::Vector3d(0, 1, -0.05).normalized(), points);
    EXPECT_NEAR(contact.deflection / 0.01, 1, points < 24 ? 0.05 : 0.01) << points;
  }
}

TEST(TireContact, BoundOfTheGroundDoesNotChangeTheResult) {
  // The same shape with and without a bound on its heights.
  const auto bounded = MakeRandomGround(-100, 0.2, 0.5, 3);
  const FunctionGround open([&](double x, double y) { return bounded->Height(x, y); });
  for (double x = 0; x < 20; x += 0.17) {
    const Eigen::Vector3d hub(x, 0.3, 0.38);
    EXPECT_NEAR(Sample(*bounded, hub).deflection, Sample(open, hub).deflection, 1e-15) << x;
  }
}

TEST(TireContact, SoilComesFromTheContactPoint) {
  const FunctionGround ground([](double, double) { return 0; }, {345e3, 0.5});
  const auto contact = Sample(ground, {0, 0, kRadius - 0.01});
  EXPECT_EQ(contact.cone_index, 345e3);
  EXPECT_EQ(contact.friction_limit, 0.5);
}

TEST(TireContact, TireFrameIsUprightAndOrthonormal) {
  const Vec3<double> y = FromEigen(Eigen::Vector3d(0.2, 0.9, -0.15).normalized());
  const Mat3<double> R = TireFrame(y);
  EXPECT_EQ(R.x.z, 0);
  EXPECT_NEAR(Norm(R.x), 1, 1e-15);
  EXPECT_NEAR(Norm(R.z), 1, 1e-15);
  EXPECT_NEAR(Dot(R.x, R.y), 0, 1e-15);
  EXPECT_GT(R.z.z, 0);
}

}  // namespace
}  // namespace dbd
