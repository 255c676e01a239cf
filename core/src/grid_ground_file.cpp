#include <dbd/core/error.h>
#include <dbd/core/scenario.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "node_grid.h"

namespace dbd {
namespace {

NodeGrid ParseHeader(const std::string& line, const std::string& file) {
  NodeGrid grid;
  const int found = std::sscanf(line.c_str(), "# x0=%lf y0=%lf d=%lf nx=%d ny=%d", &grid.x0,
                                &grid.y0, &grid.spacing, &grid.columns, &grid.rows);
  if (found != 5) {
    throw InputError(file + ", line 1: must be \"# x0=... y0=... d=... nx=... ny=...\"");
  }
  const bool sane = std::isfinite(grid.x0) && std::isfinite(grid.y0) && grid.spacing > 0 &&
                    grid.columns >= 2 && grid.rows >= 2 && grid.columns <= 100000 &&
                    grid.rows <= 100000;
  if (!sane) throw InputError(file + ", line 1: needs d > 0 and at least 2 x 2 nodes");
  return grid;
}

void ParseColumn(const std::string& line, int ix, const std::string& file, NodeGrid& grid) {
  std::istringstream cells(line);
  std::string cell;
  for (int iy = 0; iy < grid.rows; ++iy) {
    char* end = nullptr;
    const bool there = static_cast<bool>(std::getline(cells, cell, ','));
    const double height = there ? std::strtod(cell.c_str(), &end) : 0;
    if (!there || end == cell.c_str() || !std::isfinite(height)) {
      throw InputError(file + ", line " + std::to_string(ix + 2) + ": must have " +
                       std::to_string(grid.rows) + " heights");
    }
    grid.heights[grid.Index(ix, iy)] = height;
  }
}

}  // namespace

std::shared_ptr<const Ground> ReadGridGround(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": height grid cannot be opened");
  std::string line;
  std::getline(stream, line);
  NodeGrid grid = ParseHeader(line, file);
  grid.heights.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  for (int ix = 0; ix < grid.columns; ++ix) {
    if (!std::getline(stream, line)) {
      throw InputError(file + ": ends after " + std::to_string(ix) + " of " +
                       std::to_string(grid.columns) + " lines of heights");
    }
    ParseColumn(line, ix, file, grid);
  }
  return MakeGridGround(grid);
}

}  // namespace dbd
