#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace dbd {

/// Opens any vector file that GDAL reads, but never with its LIBKML driver: the one of GDAL 3.6
/// crashes on a gx:Track without times. Throws InputError that names the file.
GDALDatasetUniquePtr OpenVector(const std::string& file);

/// To longitude and latitude; null when the layer is in these already or names no system.
std::unique_ptr<OGRCoordinateTransformation> ToWgs84(const OGRLayer& layer);

bool IsCsv(const GDALDataset& dataset);

/// Whether a CSV table's places are map coordinates (columns x and y, or easting and northing).
/// Throws InputError when it has no columns of places.
bool HasMapColumns(const std::string& file, GDALDataset& dataset);

/// Throws InputError when a place is not finite, or is no longitude and latitude although it
/// should be.
void CheckPlace(const std::string& file, const Eigen::Vector2d& place, bool in_map_coordinates);

}  // namespace dbd
