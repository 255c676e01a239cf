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
    CheckPlace(file, place, path.in_map_coordinates);
  }
}

}  // namespace

GeoPath ReadGeoPath(const std::string& file) {
  const GDALDatasetUniquePtr dataset = OpenVector(file);
  GeoPath path;
  std::vector<Line> lines;
  if (IsCsv(*dataset)) {
    path.in_map_coordinates = HasMapColumns(file, *dataset);
    lines.push_back(PointsOf(file, dataset->GetLayer(0)));
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
