#include "height_scale.h"

#include <dbd/core/error.h>
#include <ogr_spatialref.h>

#include <cmath>

namespace dbd {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

// Zero when the name is not one of a unit of length.
double MetersPerUnit(const std::string& unit) {
  if (unit == "m" || unit == "metre" || unit == "meter" || unit == "metres") return 1.0;
  if (unit == "ft" || unit == "foot" || unit == "feet") return kFoot;
  if (unit == "US survey foot" || unit == "ftUS" || unit == "us-ft" || unit == "sfoot") {
    return kSurveyFoot;
  }
  if (unit == "cm" || unit == "centimetre") return 0.01;
  if (unit == "dm" || unit == "decimetre") return 0.1;
  return 0.0;
}

double MetersPerUnit(GDALDataset* dataset, GDALRasterBand* band) {
  const double of_band = MetersPerUnit(std::string(band->GetUnitType()));
  if (of_band > 0) return of_band;
  const OGRSpatialReference* crs = dataset->GetSpatialRef();
  if (crs == nullptr || !crs->IsVertical()) return 1.0;
  const double of_crs = crs->GetTargetLinearUnits("VERT_CS");
  return of_crs > 0 ? of_crs : 1.0;
}

}  // namespace

HeightScale HeightScaleOf(const std::string& name, GDALDataset* dataset, int band_number) {
  GDALRasterBand* band = dataset->GetRasterBand(band_number);
  const double to_meters = MetersPerUnit(dataset, band);
  const HeightScale result{band->GetScale() * to_meters, band->GetOffset() * to_meters};
  if (!std::isfinite(result.scale) || result.scale == 0 || !std::isfinite(result.offset)) {
    throw InputError(name + ": its scale or offset is not a usable number");
  }
  return result;
}

}  // namespace dbd
