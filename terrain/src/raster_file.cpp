#include "raster_file.h"

#include <dbd/core/error.h>

#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "height_scale.h"
#include "mosaic.h"

namespace dbd {

GDALDatasetUniquePtr OpenRaster(const std::string& name) {
  const GdalSession gdal;
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (dataset) return dataset;
  std::error_code ignored;
  const std::filesystem::path path(name);
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(name + ": is a directory, not a raster");
  }
  if (name.rfind("/vsi", 0) != 0 && !std::filesystem::exists(path, ignored)) {
    throw InputError(name + ": no such file");
  }
  std::string reason = gdal.Reason("format not recognised");
  // Most of GDAL's messages begin with the name as well.
  if (reason.rfind(name + ": ", 0) == 0) reason.erase(0, name.size() + 2);
  throw InputError(name + ": cannot be read as a raster: " + reason);
}

namespace {

GDALDatasetUniquePtr OpenAll(const std::vector<std::string>& files) {
  return files.size() == 1 ? OpenRaster(files.front()) : OpenMosaic(files);
}

std::string NameOf(const std::vector<std::string>& files) {
  DBD_ASSERT(!files.empty());
  if (files.size() == 1) return files.front();
  return files.front() + " and " + std::to_string(files.size() - 1) + " more";
}

}  // namespace

RasterFile::RasterFile(const RasterRequest& request)
    : name_(NameOf(request.files)), dataset_(OpenAll(request.files)) {
  const GdalSession gdal;
  ChooseBand(request.band);
  ReadTransform();
  ReadHeightScale(request);
  ReadCrs(request.crs);
}

void RasterFile::Fail(const std::string& what) const { throw InputError(name_ + ": " + what); }

HeightMap::Grid RasterFile::Grid() const {
  return GridOfTransform(transform_, dataset_->GetRasterXSize(), dataset_->GetRasterYSize());
}

void RasterFile::ChooseBand(int requested) {
  const int bands = dataset_->GetRasterCount();
  if (bands > 1 && requested == 0) {
    Fail("holds " + std::to_string(bands) + " bands, one must be chosen");
  }
  band_number_ = requested == 0 ? 1 : requested;
  BandOf(name_, dataset_.get(), band_number_);
}

void RasterFile::ReadTransform() {
  if (dataset_->GetGeoTransform(transform_) != CE_None) {
    Fail("has no georeference, so the size of its cells is not known");
  }
  if (!std::all_of(transform_, transform_ + 6, [](double t) { return std::isfinite(t); })) {
    Fail("its georeference is not finite");
  }
  const double turn = std::max(std::abs(transform_[2]), std::abs(transform_[4]));
  const double side = std::min(std::abs(transform_[1]), std::abs(transform_[5]));
  const double cells = std::max(dataset_->GetRasterXSize(), dataset_->GetRasterYSize());
  if (turn * cells > 1e-3 * side) Fail("is rotated; a raster whose rows run east-west is needed");
  if (transform_[1] <= 0 || side <= 0) Fail("its cells have no positive width and height");
}

void RasterFile::ReadCrs(const std::string& instead) {
  if (!instead.empty()) {
    if (crs_.SetFromUserInput(instead.c_str()) != OGRERR_NONE) {
      throw InputError("the coordinate system '" + instead + "' for " + name_ +
                       " is not understood; give EPSG:n, WKT or a PROJ string");
    }
  } else {
    const OGRSpatialReference* crs = dataset_->GetSpatialRef();
    if (crs == nullptr || crs->IsEmpty() || crs->IsLocal()) return;
    crs_ = *crs;
  }
  crs_.StripVertical();
  crs_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!crs_.IsProjected() && !crs_.IsGeographic()) {
    Fail("its coordinate system is neither projected nor geographic");
  }
  has_crs_ = true;
}

void RasterFile::ReadHeightScale(const RasterRequest& request) {
  const HeightScale scale = HeightScaleOf(name_, dataset_.get(), band_number_);
  height_scale_ = scale.scale;
  height_offset_ = scale.offset;
  // A mosaic keeps neither scale nor unit of its parts.
  if (request.files.size() == 1) return;
  for (const std::string& file : request.files) {
    const GDALDatasetUniquePtr part = OpenRaster(file);
    const HeightScale of_part = HeightScaleOf(file, part.get(), band_number_);
    const bool is_first = &file == &request.files.front();
    if (!is_first && (of_part.scale != height_scale_ || of_part.offset != height_offset_)) {
      throw InputError(file + ": has another scale, offset or unit of height than " +
                       request.files.front() + ", so they cannot be joined");
    }
    height_scale_ = of_part.scale;
    height_offset_ = of_part.offset;
  }
}

void RasterFile::CutTo(int column, int row, int columns, int rows) {
  const GdalSession gdal;
  std::vector<std::string> words = {"-of", "VRT", "-srcwin"};
  for (const int number : {column, row, columns, rows}) words.push_back(std::to_string(number));
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::unique_ptr<GDALTranslateOptions, decltype(&GDALTranslateOptionsFree)> options(
      GDALTranslateOptionsNew(arguments.data(), nullptr), &GDALTranslateOptionsFree);
  GDALDatasetUniquePtr window(GDALDataset::FromHandle(
      GDALTranslate("", GDALDataset::ToHandle(dataset_.get()), options.get(), nullptr)));
  if (!window) Fail("cannot be cut to a window: " + gdal.Reason("no reason given"));
  whole_ = std::move(dataset_);
  dataset_ = std::move(window);
  ReadTransform();
}

void CheckMemoryNeed(const std::string& name, int columns, int rows, std::size_t bytes_per_cell,
                     double limit) {
  const double bytes = static_cast<double>(columns) * rows * static_cast<double>(bytes_per_cell);
  if (bytes <= limit) return;
  char text[160];
  std::snprintf(text, sizeof text,
                ": %d x %d cells need %.2f GB of memory, at most %.2f GB are allowed", columns,
                rows, bytes / 1e9, limit / 1e9);
  throw InputError(name + text);
}

HeightMap::Grid GridOfTransform(const double* transform, int columns, int rows) {
  HeightMap::Grid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.cell_size = {transform[1], std::abs(transform[5])};
  const double south = transform[5] > 0 ? transform[3] : transform[3] + rows * transform[5];
  grid.first_center = Eigen::Vector2d(transform[0], south) + 0.5 * grid.cell_size;
  return grid;
}

GDALRasterBand* BandOf(const std::string& name, GDALDataset* dataset, int number) {
  const int bands = dataset->GetRasterCount();
  if (bands == 0) throw InputError(name + ": holds no raster band");
  if (number < 1 || number > bands) {
    throw InputError(name + ": has no band " + std::to_string(number) + ", only " +
                     std::to_string(bands));
  }
  GDALRasterBand* band = dataset->GetRasterBand(number);
  const GDALDataType type = band->GetRasterDataType();
  if (GDALDataTypeIsComplex(type)) {
    throw InputError(name + ": holds complex numbers (" + GDALGetDataTypeName(type) + ")");
  }
  return band;
}

std::string CrsNameOf(const OGRSpatialReference& crs) {
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  const std::string name = crs.GetName() ? crs.GetName() : "unnamed";
  if (!authority || !code) return name;
  return name + " (" + authority + ":" + code + ")";
}

std::string WktOf(const OGRSpatialReference& crs) {
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  crs.exportToWkt(&text, options);
  std::string wkt = text != nullptr ? text : "";
  CPLFree(text);
  return wkt;
}

}  // namespace dbd
