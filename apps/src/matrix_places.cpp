#include "matrix_places.h"

#include <dbd/core/error.h>
#include <dbd/terrain/geo_places.h>

#include <set>

namespace dbd {
namespace {

void AddFile(const std::string& file, std::vector<MatrixPlace>& places) {
  const GeoPlaces read = ReadGeoPlaces(file);
  const Coordinates coordinates = read.in_map_coordinates ? Coordinates::kMap : Coordinates::kWgs84;
  for (const GeoPlace& place : read.places) {
    const std::string number = std::to_string(places.size() + 1);
    places.push_back(
        {place.name.empty() ? number : place.name, {place.xy, place.heading_deg}, coordinates});
  }
}

}  // namespace

void RefuseTwice(const std::string& flag, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) throw InputError(flag + ": '" + name + "' is there twice");
  }
}

std::vector<MatrixPlace> ReadMatrixPlaces(const std::string& kind, const std::string& file,
                                          const std::vector<std::string>& typed,
                                          Coordinates coordinates) {
  std::vector<MatrixPlace> places;
  if (!file.empty()) AddFile(file, places);
  for (std::size_t i = 0; i < typed.size(); ++i) {
    places.push_back(
        {kind + std::to_string(i + 1), ParsePlace("--" + kind, typed[i]), coordinates});
  }
  if (places.empty()) throw InputError("--" + kind + "s or --" + kind + " is required");
  std::vector<std::string> names;
  for (const MatrixPlace& place : places) names.push_back(place.name);
  RefuseTwice("--" + kind + "s", names);
  return places;
}

}  // namespace dbd
