#pragma once

#include <dbd/terrain/terrain.h>

#include <Eigen/Core>
#include <optional>
#include <string>

namespace dbd {

/// How coordinates on the command line are meant.
enum class Coordinates {
  kMap,    ///< of the elevation file's own coordinate system
  kWgs84,  ///< longitude, latitude in degrees
};

/// A place as it was typed: two coordinates and perhaps a compass heading.
struct TypedPlace {
  Eigen::Vector2d xy = Eigen::Vector2d::Zero();
  std::optional<double> heading_deg;  ///< 0 = north, clockwise
};

/// A place in the world frame W.
struct LocalPlace {
  Eigen::Vector2d xy = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> yaw;                     ///< [rad], 0 = east, counter-clockwise
};

/// Reads "X,Y" or "X,Y,HEADING_DEG". Throws InputError that names `flag` and quotes the text.
TypedPlace ParsePlace(const std::string& flag, const std::string& text);

/// Reads "X,Y". Throws InputError that names `flag` and quotes the text.
Eigen::Vector2d ParsePoint(const std::string& flag, const std::string& text);

/// Brings a typed place into W. Throws InputError when it lies outside the map or on ground that
/// was not surveyed, or when wgs84 is asked of a terrain without a coordinate system.
LocalPlace LocatePlace(const std::string& flag, const TypedPlace& place, Coordinates coordinates,
                       const Terrain& terrain);

/// Throws InputError when `coordinates` cannot be understood on this terrain.
void RequireCoordinates(Coordinates coordinates, const Terrain& terrain);

/// Compass heading [degrees, 0..360) of a yaw [rad], and back: yaw = pi/2 - heading.
double CompassDegrees(double yaw);
double YawFromCompass(double heading_deg);

/// "564312.1, 146522.8": a place in W in the coordinates of the elevation file, for people.
std::string DescribePlace(const LocalFrame& frame, const Eigen::Vector2d& local);

}  // namespace dbd
