#include <dbd/terrain/terrain.h>

#include <utility>

namespace dbd {

Terrain::Terrain(LocalFrame frame, HeightMap heights, MaterialMap materials, ObstacleMap obstacles)
    : frame_(std::move(frame)),
      heights_(std::move(heights)),
      materials_(std::move(materials)),
      obstacles_(std::move(obstacles)) {}

void Terrain::Heights(int count, const double* x, const double* y, double* z) const {
  heights_.Heights(count, x, y, z);
}

void Terrain::Soils(int count, const double* x, const double* y, SoilSample* soil) const {
  materials_.Soils(count, x, y, soil);
}

void Terrain::HighestWithin(double radius, int count, const double* x, const double* y,
                            double* z) const {
  for (int i = 0; i < count; ++i) z[i] = heights_.HighestWithin(radius, x[i], y[i]);
}

bool Terrain::IsKnown(double x, double y) const { return heights_.IsKnown(x, y); }

}  // namespace dbd
