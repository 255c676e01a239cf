#pragma once

#include <dbd/core/error.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace dbd {

/// A fresh directory under the system's temporary one, removed at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "dbd_terrain_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string File(const std::string& name) const { return (path_ / name).string(); }
  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(File(name), std::ios::binary) << text;
    return File(name);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

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
