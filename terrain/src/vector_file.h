#pragma once

#include <gdal_priv.h>

#include <string>

namespace dbd {

/// Opens any vector file that GDAL reads, but never with its LIBKML driver: the one of GDAL 3.6
/// crashes on a gx:Track without times. Throws InputError that names the file.
GDALDatasetUniquePtr OpenVector(const std::string& file);

}  // namespace dbd
