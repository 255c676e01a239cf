#pragma once

#include <dbd/core/error.h>
#include <dbd/terrain/terrain.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/temporary_directory.h"

namespace dbd {

/// A GeoTIFF to be written; `value(column, row)` with the file's own row order.
struct TestRaster {
  int columns = 4;
  int rows = 3;
  int bands = 1;
  GDALDataType type = GDT_Float32;
  std::vector<double> transform = {500000, 1, 0, 5200000, 0, -1};
  std::string crs = "EPSG:32633";
  double nodata = std::nan("");
  bool has_nodata = false;
  double scale = 1;
  double offset = 0;
  std::string unit;
  bool is_point = false;
  std::function<double(int, int)> value = [](int, int) { return 0.0; };

  std::string Write(const std::string& file) const {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr dataset(driver->Create(file.c_str(), columns, rows, bands, type, nullptr));
    if (!transform.empty()) {
      std::vector<double> copy = transform;
      dataset->SetGeoTransform(copy.data());
    }
    if (!crs.empty()) {
      OGRSpatialReference reference;
      reference.SetFromUserInput(crs.c_str());
      reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      dataset->SetSpatialRef(&reference);
    }
    GDALRasterBand* band = dataset->GetRasterBand(1);
    if (has_nodata) band->SetNoDataValue(nodata);
    if (scale != 1) band->SetScale(scale);
    if (offset != 0) band->SetOffset(offset);
    if (!unit.empty()) band->SetUnitType(unit.c_str());
    if (is_point) dataset->SetMetadataItem("AREA_OR_POINT", "Point");
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        double number = value(column, row);
        EXPECT_EQ(
            band->RasterIO(GF_Write, column, row, 1, 1, &number, 1, 1, GDT_Float64, 0, 0, nullptr),
            CE_None);
      }
    }
    return file;
  }
};

/// Terrain of an elevation file alone.
inline std::shared_ptr<const Terrain> LoadElevationOnly(const std::string& file) {
  TerrainFiles files;
  files.elevation = file;
  return LoadTerrain(files);
}

inline double HeightAtMap(const Terrain& terrain, double x, double y) {
  const Eigen::Vector2d local = terrain.frame().ToLocal({x, y});
  return terrain.Height(local.x(), local.y());
}

/// Message of the InputError that `action` throws; empty when it throws none.
inline std::string ErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A real data file, or empty when the directory is absent.
inline std::string SharedFile(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(DBD_SHARED_DATA) / name;
  return std::filesystem::exists(path) ? path.string() : "";
}

}  // namespace dbd
