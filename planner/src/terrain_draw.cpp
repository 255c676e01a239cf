#include <dbd/core/error.h>
#include <dbd/planner/stop.h>
#include <dbd/planner/terrain_draw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "candidate_random.h"

namespace dbd {
namespace {

constexpr double kHardest = 20e6;  // [Pa] what material tables allow
constexpr std::uint64_t kHeightStream = 1000;

double Gaussian(SplitMix64& random) {
  const double u = 1 - random.Uniform();  // never zero
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * random.Uniform());
}

/// With mean 1 and this coefficient of variation: exp(sigma z - sigma^2 / 2), where
/// sigma^2 = ln(1 + c^2).
double LogNormal(double variation, double z) {
  const double variance = std::log(1 + variation * variation);
  return std::exp(std::sqrt(variance) * z - 0.5 * variance);
}

/// Weights of the four lattice points round a place by uniform cubic B-splines, scaled so that the
/// squares add up to 1: unit variance in, unit variance out.
std::array<double, 4> SplineWeights(double t) {
  const double u = 1 - t;
  std::array<double, 4> weights{u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6};
  double squares = 0;
  for (const double weight : weights) squares += weight * weight;
  for (double& weight : weights) weight /= std::sqrt(squares);
  return weights;
}

/// Smooth noise of unit variance over the cells of a grid.
class SmoothNoise {
 public:
  SmoothNoise(const HeightMap::Grid& grid, double spacing, SplitMix64 random)
      : per_cell_(grid.cell_size / spacing),
        columns_(static_cast<int>(per_cell_.x() * grid.columns) + 5),
        rows_(static_cast<int>(per_cell_.y() * grid.rows) + 5) {
    for (int i = 0; i < columns_ * rows_; ++i) lattice_.push_back(Gaussian(random));
  }

  double At(int column, int row) const {
    const double u = column * per_cell_.x(), v = row * per_cell_.y();
    const auto first_column = static_cast<int>(u), first_row = static_cast<int>(v);
    const std::array<double, 4> across = SplineWeights(u - first_column);
    const std::array<double, 4> up = SplineWeights(v - first_row);
    double value = 0;
    for (int j = 0; j < 4; ++j) {
      const double* line = &lattice_[static_cast<std::size_t>((first_row + j) * columns_)];
      for (int i = 0; i < 4; ++i) {
        value += up[static_cast<std::size_t>(j)] * across[static_cast<std::size_t>(i)] *
                 line[first_column + i];
      }
    }
    return value;
  }

 private:
  Eigen::Vector2d per_cell_;  // lattice cells per grid cell
  int columns_;
  int rows_;
  std::vector<double> lattice_;
};

MaterialMap DrawMaterials(const MaterialMap& materials, double factor, std::uint64_t seed) {
  std::vector<Material> drawn = materials.table().materials();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    SplitMix64 random(DeriveSeed(seed, i));
    const double strength = LogNormal(factor * drawn[i].cone_index_spread, Gaussian(random));
    SoilSample& soil = drawn[i].soil;
    soil.cone_index = std::min(kHardest, strength * soil.cone_index);
    soil.plate.kc *= strength;
    soil.plate.kphi *= strength;
    soil.plate.cohesion *= strength;
  }
  return materials.WithMaterials(std::move(drawn));
}

HeightMap DrawHeights(const HeightMap& heights, const TerrainSpread& spread, std::uint64_t seed,
                      const std::stop_token& stop) {
  const HeightMap::Grid& grid = heights.grid();
  const SmoothNoise noise(grid, spread.elevation_correlation,
                          SplitMix64(DeriveSeed(seed, kHeightStream)));
  const double base = heights.lowest();
  std::vector<float> drawn;
  drawn.reserve(grid.CellCount());
  for (int row = 0; row < grid.rows; ++row) {
    ThrowIfStopped(stop);
    for (int column = 0; column < grid.columns; ++column) {
      const double height =
          heights.CellHeight(column, row) - base + spread.elevation_error * noise.At(column, row);
      drawn.push_back(heights.IsCellKnown(column, row) ? static_cast<float>(height)
                                                       : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return HeightMap(grid, std::move(drawn), base);
}

void Require(bool holds, const char* field, double value, const char* rule) {
  if (holds) return;
  throw InputError(std::string(field) + " is " + std::to_string(value) + ", must be " + rule);
}

}  // namespace

void TerrainSpread::Validate() const {
  Require(soil >= 0 && soil <= 10, "soil_spread", soil, "between 0 and 10");
  Require(elevation_error >= 0 && elevation_error <= 100, "elevation_error", elevation_error,
          "between 0 and 100 m");
  Require(elevation_correlation >= 0.1, "elevation_correlation", elevation_correlation,
          "at least 0.1 m");
}

Terrain DrawTerrain(const Terrain& terrain, const TerrainSpread& spread, std::uint64_t seed,
                    int draw, const std::stop_token& stop) {
  spread.Validate();
  if (terrain.tin() != nullptr && spread.elevation_error > 0) {
    throw InputError("elevation_error: heights of a TIN cannot be drawn; rasterise it");
  }
  const std::uint64_t own = DeriveSeed(seed, static_cast<std::uint64_t>(draw));
  Terrain drawn(terrain.frame(),
                spread.elevation_error > 0 ? DrawHeights(terrain.heights(), spread, own, stop)
                                           : terrain.heights(),
                DrawMaterials(terrain.materials(), spread.soil, own), terrain.obstacles());
  drawn.set_tin(terrain.shared_tin());
  return drawn;
}

}  // namespace dbd
