#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <string>

namespace dbd {

/// How a frame of its own lies on the map: a point (x, y) of it is `origin` + the point turned by
/// `yaw` (counter-clockwise).
struct MapPlacement {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< map coordinates of its x = y = 0 [m]
  double yaw = 0;                                    ///< [rad]

  Eigen::Vector2d FromMap(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d d = place - origin;
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * d.x() + s * d.y(), c * d.y() - s * d.x()};
  }
  Eigen::Vector2d ToMap(const Eigen::Vector2d& point) const {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return origin + Eigen::Vector2d(c * point.x() - s * point.y(), s * point.x() + c * point.y());
  }
};

/// The local frame W of a terrain: metres east and north of an origin in a projected map
/// coordinate system. Coordinates are converted here on the way in and on the way out, and
/// nowhere else. Heights are those of the map. Safe to use from many threads; copies share their
/// transformations.
class LocalFrame {
 public:
  /// `map_wkt`: projected coordinate system in metres (WKT, PROJ string or "EPSG:n"), or empty
  /// when none is known. `origin`: map coordinates of W's origin.
  /// Throws InputError when the system is not understood or not projected.
  LocalFrame(std::string map_wkt, const Eigen::Vector2d& origin);
  ~LocalFrame();
  LocalFrame(const LocalFrame&);
  LocalFrame(LocalFrame&&) noexcept;
  LocalFrame& operator=(const LocalFrame&);
  LocalFrame& operator=(LocalFrame&&) noexcept;

  Eigen::Vector2d ToLocal(const Eigen::Vector2d& map) const { return map - origin_; }
  Eigen::Vector2d ToMap(const Eigen::Vector2d& local) const { return local + origin_; }

  /// Longitude and latitude in degrees (WGS84), in this order.
  /// Throws InputError when the terrain has no coordinate system or the place is beyond it.
  Eigen::Vector2d ToWgs84(const Eigen::Vector2d& local) const;
  Eigen::Vector2d FromWgs84(const Eigen::Vector2d& lon_lat) const;

  /// Coordinates in the system of the file that the terrain came from (differs from the map
  /// system when the file was geographic), x = easting or longitude.
  Eigen::Vector2d FromSource(const Eigen::Vector2d& source) const;
  Eigen::Vector2d ToSource(const Eigen::Vector2d& local) const;

  bool has_crs() const { return !map_wkt_.empty(); }
  const std::string& map_wkt() const { return map_wkt_; }
  const std::string& source_wkt() const { return source_wkt_; }
  /// Empty: the same as the map system.
  void set_source_wkt(std::string wkt);
  const Eigen::Vector2d& origin() const { return origin_; }

  /// Name of the map coordinate system; empty when there is none.
  std::string CrsName() const;

 private:
  class Transformation;

  std::string map_wkt_;
  std::string source_wkt_;
  Eigen::Vector2d origin_;
  std::shared_ptr<const Transformation> wgs84_from_map_;
  std::shared_ptr<const Transformation> source_from_map_;  // null: the same system
};

}  // namespace dbd
