#pragma once

#include <dbd/core/ground.h>

#include <Eigen/Geometry>
#include <vector>

namespace dbd {

/// Another ground turned about the z axis by `yaw` and then shifted.
class MovedGround final : public Ground {
 public:
  MovedGround(const Ground& ground, double yaw, const Eigen::Vector3d& shift)
      : ground_(ground), turn_(yaw), shift_(shift) {}

  /// Where a place of the first ground lies now.
  Eigen::Vector2d Moved(const Eigen::Vector2d& place) const {
    return turn_ * place + shift_.head<2>();
  }
  Eigen::Vector3d Moved(const Eigen::Vector3d& point) const {
    Eigen::Vector3d moved;
    moved << Moved(Eigen::Vector2d(point.head<2>())), point.z() + shift_.z();
    return moved;
  }

  void Heights(int count, const double* x, const double* y, double* z) const override {
    const Places places = Before(count, x, y);
    ground_.Heights(count, places.x.data(), places.y.data(), z);
    for (int i = 0; i < count; ++i) z[i] += shift_.z();
  }
  void Soils(int count, const double* x, const double* y, SoilSample* soil) const override {
    const Places places = Before(count, x, y);
    ground_.Soils(count, places.x.data(), places.y.data(), soil);
  }
  void HighestWithin(double radius, int count, const double* x, const double* y,
                     double* z) const override {
    const Places places = Before(count, x, y);
    ground_.HighestWithin(radius, count, places.x.data(), places.y.data(), z);
    for (int i = 0; i < count; ++i) z[i] += shift_.z();
  }

 private:
  struct Places {
    std::vector<double> x, y;
  };
  Places Before(int count, const double* x, const double* y) const {
    Places places;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d place =
          turn_.inverse() * (Eigen::Vector2d(x[i], y[i]) - shift_.head<2>());
      places.x.push_back(place.x());
      places.y.push_back(place.y());
    }
    return places;
  }

  const Ground& ground_;
  Eigen::Rotation2Dd turn_;
  Eigen::Vector3d shift_;
};

}  // namespace dbd
