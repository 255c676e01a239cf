#include <dbd/core/error.h>
#include <dbd/terrain/geo_places.h>

#include <charconv>
#include <cmath>

#include "gdal_session.h"
#include "vector_file.h"

namespace dbd {
namespace {

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

/// The text of an attribute; empty where the feature has none.
std::string Attribute(const OGRFeature& feature, const char* name) {
  const int field = feature.GetDefnRef()->GetFieldIndex(name);
  return field < 0 || !feature.IsFieldSetAndNotNull(field) ? "" : feature.GetFieldAsString(field);
}

std::optional<double> HeadingOf(const OGRFeature& feature, const std::string& origin) {
  const std::string text = Attribute(feature, "heading_deg");
  if (text.empty()) return std::nullopt;
  double heading = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, heading);
  if (error != std::errc() || stop != end || !std::isfinite(heading)) {
    Fail(origin, "heading_deg is '" + text + "', must be a number");
  }
  return heading;
}

GeoPlace ReadPlace(const OGRFeature& feature, OGRCoordinateTransformation* to_wgs84,
                   const std::string& origin) {
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (geometry == nullptr || geometry->IsEmpty()) Fail(origin, "has no two numbers for a place");
  if (wkbFlatten(geometry->getGeometryType()) != wkbPoint) {
    Fail(origin, std::string("is a ") + geometry->getGeometryName() + ", must be a point");
  }
  OGRPoint point(*geometry->toPoint());
  if (to_wgs84 != nullptr && point.transform(to_wgs84) != OGRERR_NONE) {
    Fail(origin, "its coordinates cannot be converted to WGS84");
  }
  const std::string name = Attribute(feature, "name");
  return {name.empty() ? Attribute(feature, "id") : name,
          {point.getX(), point.getY()},
          HeadingOf(feature, origin)};
}

/// A GPX file holds routes, tracks and their points beside its waypoints.
bool HoldsNoPlaces(const GDALDataset& dataset, const OGRLayer& layer) {
  return EQUAL(const_cast<GDALDataset&>(dataset).GetDriverName(), "GPX") &&
         !EQUAL(const_cast<OGRLayer&>(layer).GetName(), "waypoints");
}

}  // namespace

GeoPlaces ReadGeoPlaces(const std::string& file) {
  const GDALDatasetUniquePtr dataset = OpenVector(file);
  const GdalSession gdal;
  GeoPlaces result;
  result.in_map_coordinates = IsCsv(*dataset) && HasMapColumns(file, *dataset);
  for (OGRLayer* layer : dataset->GetLayers()) {
    if (HoldsNoPlaces(*dataset, *layer)) continue;
    const auto to_wgs84 = result.in_map_coordinates ? nullptr : ToWgs84(*layer);
    for (const auto& feature : layer) {
      const std::string origin = file + ": place " + std::to_string(result.places.size() + 1);
      result.places.push_back(ReadPlace(*feature, to_wgs84.get(), origin));
      CheckPlace(file, result.places.back().xy, result.in_map_coordinates);
    }
  }
  if (!gdal.error().empty()) Fail(file, "is corrupt: " + gdal.error());
  if (result.places.empty()) Fail(file, "holds no point");
  return result;
}

}  // namespace dbd
