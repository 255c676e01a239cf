#include "places.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "text.h"

namespace dbd {
namespace {

/// The numbers of a comma-separated list; nullopt when one of them is not a finite number.
std::optional<std::vector<double>> ParseNumbers(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && *at == ' ') ++at;
    double number = 0;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    if (stop == end) return numbers;
    if (*stop != ',') return std::nullopt;
    at = stop + 1;
  }
}

std::string DescribeBounds(const Terrain& terrain) {
  const LocalFrame& frame = terrain.frame();
  const Eigen::Vector2d low = frame.ToSource(terrain.heights().min_corner());
  const Eigen::Vector2d high = frame.ToSource(terrain.heights().max_corner());
  return Format("x %.10g to %.10g, y %.10g to %.10g", low.x(), high.x(), low.y(), high.y());
}

bool IsInside(const HeightMap& heights, const Eigen::Vector2d& local) {
  const Eigen::Vector2d low = heights.min_corner();
  const Eigen::Vector2d high = heights.max_corner();
  return (local.array() >= low.array()).all() && (local.array() <= high.array()).all();
}

}  // namespace

TypedPlace ParsePlace(const std::string& flag, const std::string& text) {
  const auto numbers = ParseNumbers(text);
  if (!numbers || numbers->size() < 2 || numbers->size() > 3) {
    throw InputError(flag + ": '" + text + "' is not X,Y or X,Y,HEADING_DEG");
  }
  TypedPlace place{{(*numbers)[0], (*numbers)[1]}, std::nullopt};
  if (numbers->size() == 3) place.heading_deg = (*numbers)[2];
  return place;
}

Eigen::Vector2d ParsePoint(const std::string& flag, const std::string& text) {
  const auto numbers = ParseNumbers(text);
  if (!numbers || numbers->size() != 2) {
    throw InputError(flag + ": '" + text + "' is not X,Y");
  }
  return {(*numbers)[0], (*numbers)[1]};
}

void RequireCoordinates(Coordinates coordinates, const Terrain& terrain) {
  if (coordinates == Coordinates::kWgs84 && !terrain.frame().has_crs()) {
    throw InputError(
        "--coords wgs84: the elevation file has no coordinate system; give map coordinates");
  }
}

LocalPlace LocatePlace(const std::string& flag, const TypedPlace& place, Coordinates coordinates,
                       const Terrain& terrain) {
  RequireCoordinates(coordinates, terrain);
  const LocalFrame& frame = terrain.frame();
  const bool wgs84 = coordinates == Coordinates::kWgs84;
  const Eigen::Vector2d local = wgs84 ? frame.FromWgs84(place.xy) : frame.FromSource(place.xy);
  const std::string typed = Format("%s %.10g,%.10g", flag.c_str(), place.xy.x(), place.xy.y());
  if (!IsInside(terrain.heights(), local)) {
    throw InputError(typed + ": outside the map, which covers " + DescribeBounds(terrain) +
                     (wgs84 ? " in its own system" : ""));
  }
  if (!terrain.IsKnown(local.x(), local.y())) {
    throw InputError(typed + ": the ground there is unknown (nodata)");
  }
  LocalPlace result{local, std::nullopt};
  if (place.heading_deg) result.yaw = YawFromCompass(*place.heading_deg);
  return result;
}

double CompassDegrees(double yaw) {
  const double heading = std::fmod(90.0 - ToDegrees(yaw), 360.0);
  return heading < 0 ? heading + 360.0 : heading;
}

double YawFromCompass(double heading_deg) { return std::numbers::pi / 2 - Degrees(heading_deg); }

std::string DescribePlace(const LocalFrame& frame, const Eigen::Vector2d& local) {
  const Eigen::Vector2d source = frame.ToSource(local);
  const bool geographic = (source - frame.ToMap(local)).norm() > 1;
  return geographic ? Format("%.6f, %.6f", source.x(), source.y())
                    : Format("%.1f, %.1f", source.x(), source.y());
}

}  // namespace dbd
