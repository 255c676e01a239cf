#include "map_window.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

namespace dbd {
namespace {

constexpr double kLeastMargin = 500;  // [cells]

// Cells, rows counted from the south.
struct Window {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
};

std::vector<Eigen::Vector2d> PlacesInFile(const RasterRequest& request, const RasterFile& file) {
  std::vector<Eigen::Vector2d> places = request.places;
  if (request.wgs84_places.empty() || file.crs() == nullptr) return places;
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_file(
      OGRCreateCoordinateTransformation(&wgs84, file.crs()));
  for (Eigen::Vector2d place : request.wgs84_places) {
    if (!to_file || !to_file->Transform(1, &place.x(), &place.y())) {
      file.Fail("the places cannot be converted to its coordinate system");
    }
    places.push_back(place);
  }
  return places;
}

// The margin m that makes (w + 2 m) (h + 2 m) equal to `cells`; negative when w h is more.
double MarginFor(const Eigen::Array2d& size, double cells) {
  const double sum = size.sum();
  const double root = sum * sum - 4 * (size.prod() - cells);
  return root < 0 ? -1 : (-sum + std::sqrt(root)) / 4;
}

Window WindowRound(const std::vector<Eigen::Vector2d>& places, const HeightMap::Grid& grid,
                   double cells) {
  Window window;
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Array2d cell = (place - grid.first_center).array() / grid.cell_size.array();
    window.low = window.low.min(cell.floor());
    window.high = window.high.max(cell.ceil() + 1);
  }
  const Eigen::Array2d size = window.high - window.low;
  const double margin =
      std::floor(std::min(MarginFor(size, cells), std::max(kLeastMargin, size.maxCoeff())));
  if (margin < 0) return Window();
  window.low = (window.low - margin).max(0);
  window.high = (window.high + margin).min(Eigen::Array2d(grid.columns, grid.rows));
  return window;
}

}  // namespace

std::string CutToMemory(const RasterRequest& request, std::size_t bytes_per_cell,
                        RasterFile* file) {
  const HeightMap::Grid grid = file->Grid();
  const double cells = request.memory_limit / static_cast<double>(bytes_per_cell);
  if (1.0 * grid.columns * grid.rows <= cells) return "";
  const std::vector<Eigen::Vector2d> places = PlacesInFile(request, *file);
  const Window window = places.empty() ? Window() : WindowRound(places, grid, cells);
  // An empty window is turned inside out.
  const Eigen::Array2i size = (window.high - window.low).max(0).cast<int>();
  if (size.minCoeff() < 2) {
    CheckMemoryNeed(file->name(), grid.columns, grid.rows, bytes_per_cell, request.memory_limit);
  }
  const int west = static_cast<int>(window.low.x());
  const int south = static_cast<int>(window.low.y());
  const int first_row = file->is_south_up() ? south : grid.rows - south - size.y();
  file->CutTo(west, first_row, size.x(), size.y());
  char text[200];
  std::snprintf(text, sizeof text,
                "of %d x %d cells a window of %d x %d is loaded, the whole would need %.2f GB",
                grid.columns, grid.rows, size.x(), size.y(),
                1.0 * grid.columns * grid.rows * static_cast<double>(bytes_per_cell) / 1e9);
  return text;
}

}  // namespace dbd
