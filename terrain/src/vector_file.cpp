#include "vector_file.h"

#include <dbd/core/error.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "gdal_session.h"

namespace dbd {
namespace {

std::vector<std::string> SafeDrivers() {
  std::vector<std::string> names;
  GDALDriverManager* manager = GetGDALDriverManager();
  for (int i = 0; i < manager->GetDriverCount(); ++i) {
    GDALDriver* driver = manager->GetDriver(i);
    const char* is_vector = driver->GetMetadataItem(GDAL_DCAP_VECTOR);
    if (is_vector == nullptr || !EQUAL(is_vector, "YES")) continue;
    if (EQUAL(driver->GetDescription(), "LIBKML")) continue;
    names.emplace_back(driver->GetDescription());
  }
  return names;
}

}  // namespace

GDALDatasetUniquePtr OpenVector(const std::string& file) {
  const GdalSession gdal;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw InputError(file + ": no such file");
  const std::vector<std::string> names = SafeDrivers();
  std::vector<const char*> drivers;
  for (const std::string& name : names) drivers.push_back(name.c_str());
  drivers.push_back(nullptr);
  // What a CSV table calls its coordinates.
  const char* const options[] = {"X_POSSIBLE_NAMES=lon,longitude,lng,x,easting",
                                 "Y_POSSIBLE_NAMES=lat,latitude,y,northing",
                                 "KEEP_GEOM_COLUMNS=YES", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                        drivers.data(), options));
  if (!dataset) {
    throw InputError(file + ": cannot be read as a path or as areas (GPX, GeoJSON, KML, CSV and " +
                     "others): " + gdal.Reason("format not recognised"));
  }
  return dataset;
}

std::unique_ptr<OGRCoordinateTransformation> ToWgs84(const OGRLayer& layer) {
  const OGRSpatialReference* layer_crs = const_cast<OGRLayer&>(layer).GetSpatialRef();
  if (layer_crs == nullptr) return nullptr;
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (layer_crs->IsSame(&wgs84)) return nullptr;
  return std::unique_ptr<OGRCoordinateTransformation>(
      OGRCreateCoordinateTransformation(layer_crs, &wgs84));
}

bool IsCsv(const GDALDataset& dataset) {
  return EQUAL(const_cast<GDALDataset&>(dataset).GetDriverName(), "CSV");
}

bool HasMapColumns(const std::string& file, GDALDataset& dataset) {
  OGRLayer* layer = dataset.GetLayer(0);
  if (layer->GetGeomType() == wkbNone) {
    throw InputError(file + ": its header has neither the columns lon and lat nor x and y");
  }
  const auto has = [&](const char* column) {
    return layer->GetLayerDefn()->GetFieldIndex(column) >= 0;
  };
  return has("x") || has("easting");
}

void CheckPlace(const std::string& file, const Eigen::Vector2d& place, bool in_map_coordinates) {
  const bool on_earth = std::abs(place.x()) <= 360 && std::abs(place.y()) <= 90;
  if (place.allFinite() && (in_map_coordinates || on_earth)) return;
  throw InputError(file + ": holds the place " + std::to_string(place.x()) + ", " +
                   std::to_string(place.y()) +
                   ", which is not a longitude and latitude in degrees");
}

}  // namespace dbd
