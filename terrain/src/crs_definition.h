#pragma once

#include <ogr_spatialref.h>

#include <string>

namespace dbd {

/// `definition`: WKT, PROJ string or "EPSG:n". Horizontal only, x = easting or longitude.
/// Throws InputError when it is not understood.
OGRSpatialReference ParseCrs(const std::string& definition);

/// Its name with its code; empty for an empty definition.
std::string CrsDefinitionName(const std::string& definition);

}  // namespace dbd
