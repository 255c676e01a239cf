#include "vector_file.h"

#include <dbd/core/error.h>

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

}  // namespace dbd
