#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "file_formats.h"
#include "load_elevation.h"
#include "raster_file.h"

namespace dbd {
namespace {

constexpr std::size_t kMostClasses = 64;

// One block of a hostile file may announce any size.
constexpr double kLargestBlockBytes = 256.0 * 1024 * 1024;

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

void CheckBlocks(const std::string& file, GDALDataset* dataset, GDALRasterBand* band) {
  int width = 0;
  int height = 0;
  band->GetBlockSize(&width, &height);
  const char* interleave = dataset->GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
  const int together = interleave && EQUAL(interleave, "PIXEL") ? dataset->GetRasterCount() : 1;
  const double bytes =
      1.0 * width * height * together * GDALGetDataTypeSizeBytes(band->GetRasterDataType());
  if (bytes > kLargestBlockBytes) Fail(file, "is stored in blocks of more than 256 MB");
}

// Goes through all cells of a band, some rows at a time.
class CellScan {
 public:
  CellScan(GDALRasterBand* band, RasterFileInfo* info)
      : band_(band),
        info_(*info),
        is_integer_(GDALDataTypeIsInteger(band->GetRasterDataType()) != 0) {}

  bool Run() {
    const int columns = band_->GetXSize();
    const int rows_at_once = std::clamp((1 << 20) / columns, 1, band_->GetYSize());
    values_.resize(static_cast<std::size_t>(columns) * rows_at_once);
    is_known_.resize(values_.size());
    for (int row = 0; row < band_->GetYSize(); row += rows_at_once) {
      if (!ReadRows(row, std::min(rows_at_once, band_->GetYSize() - row))) return false;
    }
    Store();
    return true;
  }

 private:
  bool ReadRows(int row, int count) {
    const int columns = band_->GetXSize();
    if (band_->RasterIO(GF_Read, 0, row, columns, count, values_.data(), columns, count,
                        GDT_Float64, 0, 0, nullptr) != CE_None ||
        band_->GetMaskBand()->RasterIO(GF_Read, 0, row, columns, count, is_known_.data(), columns,
                                       count, GDT_Byte, 0, 0, nullptr) != CE_None) {
      return false;
    }
    const std::size_t cells = static_cast<std::size_t>(columns) * count;
    for (std::size_t i = 0; i < cells; ++i) Visit(values_[i], is_known_[i] != 0);
    return true;
  }

  void Visit(double value, bool is_known) {
    ++cells_;
    if (!is_known || !std::isfinite(value)) return;
    ++known_;
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
    if (!is_integer_ || value == last_class_ || classes_.size() > kMostClasses) return;
    last_class_ = value;
    classes_.insert(static_cast<std::int64_t>(value));
  }

  void Store() {
    info_.nodata_share = 1.0 - static_cast<double>(known_) / static_cast<double>(cells_);
    if (known_ == 0) return;
    const double scale = band_->GetScale();
    const double ends[] = {scale * lowest_ + band_->GetOffset(),
                           scale * highest_ + band_->GetOffset()};
    info_.lowest = std::min(ends[0], ends[1]);
    info_.highest = std::max(ends[0], ends[1]);
    if (classes_.size() <= kMostClasses) info_.classes.assign(classes_.begin(), classes_.end());
  }

  GDALRasterBand* band_;
  RasterFileInfo& info_;
  bool is_integer_;
  std::vector<double> values_;
  std::vector<std::uint8_t> is_known_;
  std::size_t cells_ = 0;
  std::size_t known_ = 0;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
  double last_class_ = std::numeric_limits<double>::quiet_NaN();
  std::set<std::int64_t> classes_;
};

std::string UnitName(const OGRSpatialReference& crs) {
  const char* name = nullptr;
  if (crs.IsGeographic()) {
    crs.GetAngularUnits(&name);
  } else {
    crs.GetLinearUnits(&name);
  }
  return name != nullptr ? name : "";
}

void DescribeGrid(GDALDataset* dataset, RasterFileInfo* info) {
  info->columns = dataset->GetRasterXSize();
  info->rows = dataset->GetRasterYSize();
  info->bands = dataset->GetRasterCount();
  double transform[6];
  info->has_georeference = dataset->GetGeoTransform(transform) == CE_None;
  if (info->has_georeference) info->cell_size = {transform[1], transform[5]};
  const OGRSpatialReference* crs = dataset->GetSpatialRef();
  if (crs == nullptr || crs->IsEmpty()) return;
  info->crs_name = CrsNameOf(*crs);
  info->unit = UnitName(*crs);
}

// Pages of a TIFF and the like.
int ImageCount(GDALDataset* dataset) {
  char** names_and_descriptions = dataset->GetMetadata("SUBDATASETS");
  return CSLCount(names_and_descriptions) / 2;
}

bool IsColour(GDALColorInterp interpretation) {
  return interpretation >= GCI_RedBand && interpretation <= GCI_YCbCr_CrBand;
}

std::vector<std::string> WarningsOf(const RasterFileInfo& raster, GDALDataset* dataset,
                                    GDALRasterBand* band) {
  std::vector<std::string> warnings;
  if (!raster.lowest) warnings.emplace_back("every cell is nodata");
  if (!raster.has_georeference) warnings.emplace_back("has no georeference");
  if (raster.crs_name.empty()) warnings.emplace_back("has no coordinate system");
  const GDALColorInterp interpretation = band->GetColorInterpretation();
  if (IsColour(interpretation)) {
    warnings.push_back("its band " + std::to_string(band->GetBand()) + " holds a colour (" +
                       GDALGetColorInterpretationName(interpretation) + "), not heights");
  }
  const int images = ImageCount(dataset);
  if (images > 1) {
    warnings.push_back("holds " + std::to_string(images) + " images, of which the first is read");
  }
  return warnings;
}

}  // namespace

FileInfo DescribeRasterFile(const std::string& file, int band_number) {
  const GdalSession gdal;
  const GDALDatasetUniquePtr dataset = OpenRaster(file);
  FileInfo info;
  info.format = dataset->GetDriverName();
  RasterFileInfo raster;
  DescribeGrid(dataset.get(), &raster);
  GDALRasterBand* band = BandOf(file, dataset.get(), band_number == 0 ? 1 : band_number);
  raster.data_type = GDALGetDataTypeName(band->GetRasterDataType());
  int has_nodata = 0;
  const double nodata = band->GetNoDataValue(&has_nodata);
  if (has_nodata) raster.nodata = nodata;
  raster.memory_bytes_to_load = ElevationMemoryNeed(raster.columns, raster.rows);
  CheckBlocks(file, dataset.get(), band);
  if (!CellScan(band, &raster).Run() || !gdal.error().empty()) {
    Fail(file, "is corrupt: " + gdal.Reason("read error"));
  }
  info.warnings = WarningsOf(raster, dataset.get(), band);
  info.warnings.insert(info.warnings.end(), gdal.warnings().begin(), gdal.warnings().end());
  info.content = std::move(raster);
  return info;
}

}  // namespace dbd
