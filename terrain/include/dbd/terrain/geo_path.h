#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace dbd {

/// A path that was read from a file.
struct GeoPath {
  /// Longitude and latitude (WGS84) [deg]; or, when `in_map_coordinates`, x and y as in the file.
  /// At least two, no two neighbours the same.
  std::vector<Eigen::Vector2d> points;
  bool in_map_coordinates = false;
  int line_count = 1;  ///< lines in the file; `points` is the longest of them
};

/// Reads a GPX route or track, a line of GeoJSON, KML, GeoPackage or any other OGR format, or a CSV
/// table with one point per row and a header with lon and lat (also longitude, latitude) or x and y
/// (also easting, northing: map coordinates). Heights are ignored. Throws InputError when there is
/// no file, no line, a line of fewer than two places, or coordinates beyond the Earth.
GeoPath ReadGeoPath(const std::string& file);

}  // namespace dbd
