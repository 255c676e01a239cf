#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// A place that was read from a file.
struct GeoPlace {
  std::string name;  ///< its attribute name or id; empty where it has none
  /// Longitude and latitude (WGS84) [deg]; or, when `in_map_coordinates`, x and y as in the file.
  Eigen::Vector2d xy = Eigen::Vector2d::Zero();
  std::optional<double> heading_deg;  ///< attribute of this name: compass, 0 = north, clockwise
};

struct GeoPlaces {
  std::vector<GeoPlace> places;  ///< at least one, in the order of the file
  bool in_map_coordinates = false;
};

/// Reads the points of GeoJSON, GPX (waypoints), KML, GeoPackage or any other OGR format, or a CSV
/// table with the columns of `ReadGeoPath`. Heights are ignored. Throws InputError when there is no
/// file, no point, something that is no point, or coordinates beyond the Earth.
GeoPlaces ReadGeoPlaces(const std::string& file);

}  // namespace dbd
