#include "delaunay.h"

#include <dbd/core/error.h>
#include <gdal_alg.h>

#include <cmath>
#include <limits>
#include <memory>

#include "gdal_session.h"

namespace dbd {
namespace {

// Twice the largest area of a triangle of the first point, the farthest from it and a third; the
// triangulation itself reports points on a line on the error stream.
bool SpanAnArea(const std::vector<double>& x, const std::vector<double>& y) {
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::hypot(x[i], y[i]) > std::hypot(x[farthest], y[farthest])) farthest = i;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[farthest] * y[i] - y[farthest] * x[i]) > 1e-6) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> Triangulate(const std::string& name,
                                                      const std::vector<Eigen::Vector3d>& points) {
  const GdalSession gdal;
  if (points.size() > std::numeric_limits<int>::max()) throw InputError(name + ": too many points");
  // Relative to the first point: the triangulation works with limited precision.
  std::vector<double> x;
  std::vector<double> y;
  for (const Eigen::Vector3d& point : points) {
    x.push_back(point.x() - points.front().x());
    y.push_back(point.y() - points.front().y());
  }
  if (!SpanAnArea(x, y)) {
    throw InputError(name + ": its points cannot be triangulated: they span no area");
  }
  const std::unique_ptr<GDALTriangulation, decltype(&GDALTriangulationFree)> triangulation(
      GDALTriangulationCreateDelaunay(static_cast<int>(points.size()), x.data(), y.data()),
      &GDALTriangulationFree);
  if (!triangulation || triangulation->nFacets == 0) {
    throw InputError(name +
                     ": its points cannot be triangulated: " + gdal.Reason("no reason given"));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (int i = 0; i < triangulation->nFacets; ++i) {
    const int* v = triangulation->pasFacets[i].anVertexIdx;
    triangles.push_back({static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                         static_cast<std::uint32_t>(v[2])});
  }
  return triangles;
}

}  // namespace dbd
