#include "load_tin.h"

#include <dbd/core/error.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "delaunay.h"
#include "file_extension.h"
#include "mesh_file.h"
#include "point_file.h"

namespace dbd {
namespace {

constexpr double kMostCells = 6e7;

TriangleMesh ReadSurface(const std::string& file) {
  if (IsMeshExtension(LowerExtension(file))) return ReadMesh(file);
  std::vector<Eigen::Vector3d> points = ReadXyz(file);
  std::vector<std::array<std::uint32_t, 3>> triangles = Triangulate(file, points);
  return {std::move(points), std::move(triangles)};
}

void MoveToMap(const MapPlacement& placement, TriangleMesh* mesh) {
  for (Eigen::Vector3d& vertex : mesh->vertices) {
    vertex.head<2>() = placement.ToMap(vertex.head<2>());
  }
}

// Cells half as wide as the triangles, unless the user says otherwise; centres inside the surface.
HeightMap::Grid GridOver(const std::string& file, const TinSurface& tin, double cell_size) {
  HeightMap::Grid grid;
  const double side = cell_size > 0 ? cell_size : 0.5 * tin.spacing();
  const Eigen::Vector2d size = tin.max_corner() - tin.min_corner();
  const Eigen::Array2d cells = (size / side).array().floor() + 1;
  if (cells.prod() > kMostCells) {
    throw InputError(file +
                     ": its raster would have more than 60 million cells; choose larger ones");
  }
  grid.columns = std::max(2, static_cast<int>(cells.x()));
  grid.rows = std::max(2, static_cast<int>(cells.y()));
  grid.cell_size = Eigen::Vector2d::Constant(side);
  grid.first_center = tin.min_corner();
  return grid;
}

void SampleHeights(const TinSurface& tin, ElevationRaster* raster) {
  const HeightMap::Grid& grid = raster->grid;
  raster->heights.assign(grid.CellCount(), std::numeric_limits<float>::quiet_NaN());
  bool has_base = false;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d place = grid.Center(column, row);
      double height = 0;
      if (!tin.FindHeight(place.x(), place.y(), &height)) continue;
      if (!has_base) raster->base_height = std::round(height);
      has_base = true;
      raster->heights[static_cast<std::size_t>(row) * grid.columns + column] =
          static_cast<float>(height - raster->base_height);
    }
  }
}

void AddNotes(const TinSurface::Report& report, std::vector<std::string>* notes) {
  char text[200];
  std::snprintf(text, sizeof text, "the TIN has %zu triangles, %zu boundary edges and %zu holes",
                report.triangles, report.boundary_edges, report.holes);
  notes->emplace_back(text);
  if (report.vertical > 0) {
    std::snprintf(text, sizeof text, "%zu triangles stand upright and are left out",
                  report.vertical);
    notes->emplace_back(text);
  }
  if (report.overlap_share > 0) {
    std::snprintf(text, sizeof text,
                  "several sheets lie over each other on %.3g %% of it; the lowest is the ground",
                  100 * report.overlap_share);
    notes->emplace_back(text);
  }
}

// Bilinear, at a place in cells; not a number next to unknown cells.
double RasterHeight(const ElevationRaster& raster, const Eigen::Vector2d& place) {
  const Eigen::Array2d cell = place.array().floor();
  const Eigen::Array2d part = place.array() - cell;
  const auto columns = static_cast<std::size_t>(raster.grid.columns);
  const float* south = raster.heights.data() + static_cast<std::size_t>(cell.y()) * columns +
                       static_cast<std::size_t>(cell.x());
  const float* north = south + columns;
  const double south_z = (1 - part.x()) * south[0] + part.x() * south[1];
  const double north_z = (1 - part.x()) * north[0] + part.x() * north[1];
  return raster.base_height + (1 - part.y()) * south_z + part.y() * north_z;
}

// Root mean square of how far the raster lies off its triangles [m], over places that an additive
// recurrence spreads evenly.
double RasterError(const TinSurface& tin, const ElevationRaster& raster) {
  constexpr int kPlaces = 20000;
  const HeightMap::Grid& grid = raster.grid;
  const Eigen::Vector2d squares(grid.columns - 1, grid.rows - 1);
  double sum = 0;
  int count = 0;
  for (int i = 1; i <= kPlaces; ++i) {
    const Eigen::Vector2d share(std::fmod(0.7548776662466927 * i, 1.0),
                                std::fmod(0.5698402909980532 * i, 1.0));
    const Eigen::Vector2d in_cells = squares.cwiseProduct(share);
    const Eigen::Vector2d place = grid.first_center + grid.cell_size.cwiseProduct(in_cells);
    const double of_raster = RasterHeight(raster, in_cells);
    double of_tin = 0;
    if (std::isnan(of_raster) || !tin.FindHeight(place.x(), place.y(), &of_tin)) continue;
    sum += (of_raster - of_tin) * (of_raster - of_tin);
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

std::string RasterNote(const TinSurface& tin, const ElevationRaster& raster) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "a raster of it on cells of %.3g m lacks its creases (%.2g m rms): drives on that are "
      "smoother and faster than on the triangles",
      raster.grid.cell_size.x(), RasterError(tin, raster));
  return text;
}

}  // namespace

Eigen::Vector2d OriginOf(const HeightMap::Grid& map_grid) {
  const Eigen::Vector2d center =
      0.5 * (map_grid.first_center + map_grid.Center(map_grid.columns - 1, map_grid.rows - 1));
  // Whole metres, so that local and map coordinates differ by a number that is easy to read.
  return {std::round(center.x()), std::round(center.y())};
}

std::string MetricCrs(const std::string& file, const std::string& crs) {
  if (crs.empty()) return "";
  const GdalSession gdal;
  OGRSpatialReference reference;
  if (reference.SetFromUserInput(crs.c_str()) != OGRERR_NONE) {
    throw InputError("the coordinate system '" + crs + "' for " + file + " is not understood");
  }
  if (!reference.IsProjected() || std::abs(reference.GetLinearUnits() - 1) > 1e-9) {
    throw InputError("the coordinate system '" + crs + "' for " + file +
                     " is not a projected one in metres");
  }
  return WktOf(reference);
}

TinGround LoadTin(const TerrainFiles& files, std::vector<std::string>* notes) {
  const std::string& file = files.elevation;
  TinGround ground;
  ground.raster.map_wkt = ground.raster.source_wkt = MetricCrs(file, files.crs);
  TriangleMesh mesh = ReadSurface(file);
  MoveToMap(files.elevation_placement, &mesh);
  // Once in map coordinates to find the middle, then relative to it.
  const TinSurface in_map(mesh.vertices, mesh.triangles);
  ground.raster.grid = GridOver(file, in_map, files.surface_cell_size);
  SampleHeights(in_map, &ground.raster);
  const std::string raster_note = RasterNote(in_map, ground.raster);
  const Eigen::Vector2d origin = OriginOf(ground.raster.grid);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.head<2>() -= origin;
  auto tin =
      std::make_shared<const TinSurface>(std::move(mesh.vertices), std::move(mesh.triangles));
  AddNotes(tin->report(), notes);
  notes->push_back(raster_note);
  if (!files.rasterise_tin) ground.tin = std::move(tin);
  return ground;
}

}  // namespace dbd
