#include "crs_definition.h"

#include <dbd/core/error.h>

#include "gdal_session.h"
#include "raster_file.h"

namespace dbd {

OGRSpatialReference ParseCrs(const std::string& definition) {
  OGRSpatialReference crs;
  if (crs.SetFromUserInput(definition.c_str()) != OGRERR_NONE) {
    throw InputError("the coordinate system '" + definition.substr(0, 60) + "' is not understood");
  }
  crs.StripVertical();
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string CrsDefinitionName(const std::string& definition) {
  if (definition.empty()) return "";
  const GdalSession gdal;
  return CrsNameOf(ParseCrs(definition));
}

}  // namespace dbd
