#include <dbd/terrain/terrain.h>
#include <dbd/terrain/tin_surface.h>

#include <algorithm>
#include <utility>

namespace dbd {

Terrain::Terrain(LocalFrame frame, HeightMap heights, MaterialMap materials, ObstacleMap obstacles)
    : frame_(std::move(frame)),
      heights_(std::move(heights)),
      materials_(std::move(materials)),
      obstacles_(std::move(obstacles)) {}

void Terrain::Heights(int count, const double* x, const double* y, double* z) const {
  if (!tin_) return heights_.Heights(count, x, y, z);
  // Off the triangles the raster continues their heights.
  for (int i = 0; i < count; ++i) {
    if (!tin_->FindHeight(x[i], y[i], &z[i])) z[i] = heights_.Height(x[i], y[i]);
  }
}

void Terrain::Soils(int count, const double* x, const double* y, SoilSample* soil) const {
  materials_.Soils(count, x, y, soil);
}

void Terrain::HighestWithin(double radius, int count, const double* x, const double* y,
                            double* z) const {
  for (int i = 0; i < count; ++i) z[i] = heights_.HighestWithin(radius, x[i], y[i]);
  if (!tin_) return;
  // The raster may miss summits between its cells; off the triangles it is the ground.
  for (int i = 0; i < count; ++i) z[i] = std::max(z[i], tin_->HighestWithin(radius, x[i], y[i]));
}

std::optional<GroundGrid> Terrain::Grid() const {
  if (tin_) return std::nullopt;
  return heights_.View();
}

std::optional<GroundSoils> Terrain::SoilClasses() const { return materials_.View(); }

std::optional<GroundFacets> Terrain::Facets() const {
  if (!tin_) return std::nullopt;
  return tin_->View();
}

bool Terrain::IsKnown(double x, double y) const {
  double z = 0;
  return tin_ ? tin_->FindHeight(x, y, &z) : heights_.IsKnown(x, y);
}

bool Terrain::IsBoxKnown(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  return !tin_ && heights_.IsBoxKnown(low, high);
}

}  // namespace dbd
