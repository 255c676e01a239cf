#include <dbd/core/error.h>
#include <dbd/core/units.h>
#include <dbd/terrain/geo_path.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "gdal_session.h"
#include "vector_file.h"

namespace dbd {
namespace {

using Line = std::vector<Eigen::Vector2d>;

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

// To WGS84, x = longitude; null when the layer already is.
std::unique_ptr<OGRCoordinateTransformation> ToWgs84(const OGRLayer& layer) {
  const OGRSpatialReference* layer_crs = const_cast<OGRLayer&>(layer).GetSpatialRef();
  if (layer_crs == nullptr) return nullptr;
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (layer_crs->IsSame(&wgs84)) return nullptr;
  return std::unique_ptr<OGRCoordinateTransformation>(
      OGRCreateCoordinateTransformation(layer_crs, &wgs84));
}

// Every line string in a geometry, also inside collections.
void CollectLines(const OGRGeometry& geometry, std::vector<Line>* lines) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbLineString) {
    Line line;
    for (const OGRPoint& point : *geometry.toLineString()) {
      const Eigen::Vector2d place(point.getX(), point.getY());
      if (line.empty() || line.back() != place) line.push_back(place);
    }
    lines->push_back(std::move(line));
  } else if (type == wkbMultiLineString || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) CollectLines(*part, lines);
  }
}

std::vector<Line> LinesOf(const std::string& file, GDALDataset* dataset) {
  const GdalSession gdal;
  std::vector<Line> lines;
  for (OGRLayer* layer : dataset->GetLayers()) {
    const auto to_wgs84 = ToWgs84(*layer);
    for (const auto& feature : layer) {
      OGRGeometry* geometry = feature->GetGeometryRef();
      if (geometry == nullptr) continue;
      if (to_wgs84 && geometry->transform(to_wgs84.get()) != OGRERR_NONE) {
        Fail(file, "its coordinates cannot be converted to WGS84: " + gdal.Reason("no reason"));
      }
      CollectLines(*geometry, &lines);
    }
  }
  if (!gdal.error().empty()) Fail(file, "is corrupt: " + gdal.error());
  return lines;
}

// A table of points is one line.
Line PointsOf(const std::string& file, OGRLayer* layer) {
  const GdalSession gdal;
  Line line;
  int row = 1;  // of the header
  for (const auto& feature : layer) {
    ++row;
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbPoint) {
      Fail(file, "line " + std::to_string(row) + " has no two numbers for a place");
    }
    const OGRPoint* point = geometry->toPoint();
    const Eigen::Vector2d place(point->getX(), point->getY());
    if (line.empty() || line.back() != place) line.push_back(place);
  }
  if (!gdal.error().empty()) Fail(file, "is corrupt: " + gdal.error());
  return line;
}

bool HasColumn(OGRLayer* layer, const char* name) {
  return layer->GetLayerDefn()->GetFieldIndex(name) >= 0;
}

// Degrees of longitude count as much as they are long.
double LengthOf(const Line& line, bool is_geographic) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Eigen::Vector2d step = line[i] - line[i - 1];
    if (is_geographic) step.x() *= std::cos(Degrees(line[i].y()));
    length += step.norm();
  }
  return length;
}

void CheckPlaces(const std::string& file, const GeoPath& path) {
  for (const Eigen::Vector2d& place : path.points) {
    const bool on_earth = std::abs(place.x()) <= 360 && std::abs(place.y()) <= 90;
    if (place.allFinite() && (path.in_map_coordinates || on_earth)) continue;
    Fail(file, "holds the place " + std::to_string(place.x()) + ", " + std::to_string(place.y()) +
                   ", which is not a longitude and latitude in degrees");
  }
}

}  // namespace

GeoPath ReadGeoPath(const std::string& file) {
  const GDALDatasetUniquePtr dataset = OpenVector(file);
  GeoPath path;
  std::vector<Line> lines;
  if (EQUAL(dataset->GetDriverName(), "CSV")) {
    OGRLayer* layer = dataset->GetLayer(0);
    if (layer->GetGeomType() == wkbNone) {
      Fail(file, "its header has neither the columns lon and lat nor x and y");
    }
    path.in_map_coordinates = HasColumn(layer, "x") || HasColumn(layer, "easting");
    lines.push_back(PointsOf(file, layer));
  } else {
    lines = LinesOf(file, dataset.get());
  }
  if (lines.empty()) Fail(file, "holds no line (route, track or line string)");
  path.line_count = static_cast<int>(lines.size());
  double longest = -1;
  for (Line& line : lines) {
    const double length = LengthOf(line, !path.in_map_coordinates);
    if (length <= longest) continue;
    longest = length;
    path.points = std::move(line);
  }
  if (path.points.size() < 2) Fail(file, "its line has fewer than two different places");
  CheckPlaces(file, path);
  return path;
}

}  // namespace dbd
