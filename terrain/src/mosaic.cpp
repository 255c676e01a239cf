#include "mosaic.h"

#include <dbd/core/error.h>
#include <gdal_utils.h>

#include <array>
#include <memory>

#include "gdal_session.h"
#include "raster_file.h"

namespace dbd {

GDALDatasetUniquePtr OpenMosaic(const std::vector<std::string>& files) {
  std::vector<const char*> names;
  for (const std::string& file : files) {
    OpenRaster(file);  // says what is wrong with a single file
    names.push_back(file.c_str());
  }
  const GdalSession gdal;
  std::array<const char*, 6> arguments = {"-strict", "-resolution", "highest",
                                          "-r",      "bilinear",    nullptr};
  const std::unique_ptr<GDALBuildVRTOptions, decltype(&GDALBuildVRTOptionsFree)> options(
      GDALBuildVRTOptionsNew(const_cast<char**>(arguments.data()), nullptr),
      &GDALBuildVRTOptionsFree);
  GDALDatasetUniquePtr mosaic(GDALDataset::FromHandle(GDALBuildVRT(
      "", static_cast<int>(names.size()), nullptr, names.data(), options.get(), nullptr)));
  if (!mosaic || !gdal.error().empty()) {
    throw InputError(files.front() + " and " + std::to_string(files.size() - 1) +
                     " more: cannot be joined to one raster: " + gdal.Reason("no reason given"));
  }
  return mosaic;
}

}  // namespace dbd
