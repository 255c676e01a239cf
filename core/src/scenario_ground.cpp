#include <dbd/core/internal/clamp_index.h>
#include <dbd/core/scenario.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "node_grid.h"

namespace dbd {
namespace {

/// Soil is the same everywhere; heights come from the derived class's HeightAt, without a virtual
/// call per point.
template <class Shape>
class ShapedGround : public Ground {
 public:
  void Heights(int count, const double* x, const double* y, double* z) const override {
    const Shape& shape = static_cast<const Shape&>(*this);
    for (int i = 0; i < count; ++i) z[i] = shape.HeightAt(x[i], y[i]);
  }

  void Soils(int count, const double*, const double*, SoilSample* soil) const override {
    std::fill_n(soil, count, soil_);
  }

  void HighestWithin(double radius, int count, const double* x, const double* y,
                     double* z) const override {
    const Shape& shape = static_cast<const Shape&>(*this);
    for (int i = 0; i < count; ++i) z[i] = shape.HighestAt(x[i], y[i], radius);
  }

 protected:
  SoilSample soil_;
};

class BumpGround final : public ShapedGround<BumpGround> {
 public:
  BumpGround(double x, double radius, TrackSide side) : x_(x), radius_(radius), side_(side) {}

  double HeightAt(double x, double y) const {
    if (side_ == TrackSide::kLeft && y < 0) return 0;
    if (side_ == TrackSide::kRight && y > 0) return 0;
    const double d2 = radius_ * radius_ - (x - x_) * (x - x_);
    return d2 > 0 ? std::sqrt(d2) : 0;
  }
  double HighestAt(double x, double, double reach) const {
    return std::abs(x - x_) <= reach + radius_ ? radius_ : 0;
  }

 private:
  double x_;
  double radius_;
  TrackSide side_;
};

class SineGround final : public ShapedGround<SineGround> {
 public:
  SineGround(double begin, double end, double amplitude, double wavelength)
      : begin_(begin),
        end_(end),
        amplitude_(amplitude),
        wave_number_(2 * std::numbers::pi / wavelength) {}

  double HeightAt(double x, double) const {
    if (x <= begin_ || x >= end_) return 0;
    return amplitude_ * std::sin(wave_number_ * (x - begin_));
  }
  /// A crest within reach, or else the higher end of the stretch.
  double HighestAt(double x, double, double reach) const {
    const double wavelength = 2 * std::numbers::pi / wave_number_;
    const double first_crest = begin_ + 0.25 * wavelength;
    const double next = std::ceil((x - reach - first_crest) / wavelength);
    const double crest = first_crest + std::max(0.0, next) * wavelength;
    if (crest <= x + reach && crest < end_) return amplitude_;
    return std::max(HeightAt(x - reach, 0), HeightAt(x + reach, 0));
  }

 private:
  double begin_, end_, amplitude_, wave_number_;
};

/// SplitMix64 of a node's indices and the seed, as a number in [0, 1).
double NodeValue(std::int64_t ix, std::int64_t iy, std::uint64_t seed) {
  std::uint64_t h = seed + 0x9e3779b97f4a7c15ull * (static_cast<std::uint64_t>(ix) * 1000003ull +
                                                    static_cast<std::uint64_t>(iy) + 1);
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1.0p-53;
}

/// Heights at the nodes of a square grid, bilinear; beyond it the edge goes on.
class GridGround final : public ShapedGround<GridGround> {
 public:
  GridGround(const NodeGrid& grid) : grid_(grid), inverse_(1 / grid.spacing) {}

  double HeightAt(double x, double y) const {
    const double u = internal::ClampIndex((x - grid_.x0) * inverse_, grid_.columns - 1.001);
    const double v = internal::ClampIndex((y - grid_.y0) * inverse_, grid_.rows - 1.001);
    const int ix = static_cast<int>(u), iy = static_cast<int>(v);
    const double fx = u - ix, fy = v - iy;
    const double* south_nodes = &grid_.heights[grid_.Index(ix, iy)];
    const double* north_nodes = south_nodes + grid_.columns;
    const double south = south_nodes[0] + fx * (south_nodes[1] - south_nodes[0]);
    const double north = north_nodes[0] + fx * (north_nodes[1] - north_nodes[0]);
    return south + fy * (north - south);
  }

  double HighestAt(double x, double y, double reach) const {
    const auto cell = [&](double u, int count) {
      return static_cast<int>(internal::ClampIndex(u * inverse_, count - 2.0));
    };
    const int first = cell(x - reach - grid_.x0, grid_.columns);
    const int last = cell(x + reach - grid_.x0, grid_.columns) + 1;
    const int north = cell(y + reach - grid_.y0, grid_.rows) + 1;
    double highest = grid_.heights[grid_.Index(first, north)];
    for (int iy = cell(y - reach - grid_.y0, grid_.rows); iy <= north; ++iy) {
      for (int ix = first; ix <= last; ++ix) {
        highest = std::max(highest, grid_.heights[grid_.Index(ix, iy)]);
      }
    }
    return highest;
  }

 private:
  NodeGrid grid_;
  double inverse_;
};

class PlaneGround final : public ShapedGround<PlaneGround> {
 public:
  PlaneGround(double grade_x, double grade_y, const SoilSample& soil)
      : grade_x_(grade_x), grade_y_(grade_y), steepest_(std::hypot(grade_x, grade_y)) {
    soil_ = soil;
  }

  double HeightAt(double x, double y) const { return grade_x_ * x + grade_y_ * y; }
  double HighestAt(double x, double y, double reach) const {
    return HeightAt(x, y) + steepest_ * reach;
  }

 private:
  double grade_x_, grade_y_, steepest_;
};

}  // namespace

std::shared_ptr<const Ground> MakeBumpGround(double x, double radius, TrackSide side) {
  return std::make_shared<BumpGround>(x, radius, side);
}

std::shared_ptr<const Ground> MakeSineGround(double x_begin, double x_end, double amplitude,
                                             double wavelength) {
  return std::make_shared<SineGround>(x_begin, x_end, amplitude, wavelength);
}

std::shared_ptr<const Ground> MakeRandomGround(double x_begin, double amplitude, double spacing,
                                               std::uint64_t seed) {
  // A strip wide and long enough for the drives.
  NodeGrid grid{512, 64, -32 * spacing, -32 * spacing, spacing, {}};
  for (int iy = 0; iy < grid.rows; ++iy) {
    for (int ix = 0; ix < grid.columns; ++ix) {
      const bool level = grid.x0 + ix * spacing < x_begin;
      grid.heights.push_back(level ? 0 : amplitude * NodeValue(ix, iy, seed));
    }
  }
  return MakeGridGround(grid);
}

std::shared_ptr<const Ground> MakeGridGround(const NodeGrid& grid) {
  return std::make_shared<GridGround>(grid);
}

std::shared_ptr<const Ground> MakePlaneGround(double grade_x, double grade_y,
                                              const SoilSample& soil) {
  return std::make_shared<PlaneGround>(grade_x, grade_y, soil);
}

}  // namespace dbd
