#include <dbd/core/scenario.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  BumpGround(double x, double radius) : x_(x), radius_(radius) {}

  double HeightAt(double x, double) const {
    const double d2 = radius_ * radius_ - (x - x_) * (x - x_);
    return d2 > 0 ? std::sqrt(d2) : 0;
  }
  double HighestAt(double x, double, double reach) const {
    return std::abs(x - x_) <= reach + radius_ ? radius_ : 0;
  }

 private:
  double x_;
  double radius_;
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
  double HighestAt(double x, double, double reach) const {
    // No steeper than amplitude * wave number anywhere.
    const double rise = amplitude_ * wave_number_ * reach;
    return std::min(HeightAt(x, 0) + rise, amplitude_);
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

/// Nodes are drawn once for a strip wide and long enough for the drives; beyond it the edge goes
/// on.
class RandomGround final : public ShapedGround<RandomGround> {
 public:
  RandomGround(double begin, double amplitude, double spacing, std::uint64_t seed)
      : spacing_(spacing), inverse_(1 / spacing) {
    nodes_.resize(static_cast<std::size_t>(kColumns) * kRows);
    for (int iy = 0; iy < kRows; ++iy) {
      for (int ix = 0; ix < kColumns; ++ix) {
        const bool level = (ix + kFirstColumn) * spacing < begin;
        nodes_[Index(ix, iy)] = level ? 0 : amplitude * NodeValue(ix, iy, seed);
      }
    }
  }

  double HeightAt(double x, double y) const {
    const double u = std::clamp(x * inverse_ - kFirstColumn, 0.0, kColumns - 1.001);
    const double v = std::clamp(y * inverse_ - kFirstRow, 0.0, kRows - 1.001);
    const int ix = static_cast<int>(u), iy = static_cast<int>(v);
    const double fx = u - ix, fy = v - iy;
    const double* n = &nodes_[Index(ix, iy)];
    const double south = n[0] + fx * (n[1] - n[0]);
    const double north = n[kColumns] + fx * (n[kColumns + 1] - n[kColumns]);
    return south + fy * (north - south);
  }
  double HighestAt(double x, double y, double reach) const {
    const auto column = [&](double a) { return Cell(a * inverse_ - kFirstColumn, kColumns); };
    const auto row = [&](double a) { return Cell(a * inverse_ - kFirstRow, kRows); };
    double highest = 0;
    for (int iy = row(y - reach); iy <= row(y + reach) + 1; ++iy) {
      for (int ix = column(x - reach); ix <= column(x + reach) + 1; ++ix) {
        highest = std::max(highest, nodes_[Index(ix, iy)]);
      }
    }
    return highest;
  }

 private:
  static constexpr int kColumns = 512, kRows = 64, kFirstColumn = -32, kFirstRow = -32;

  static std::size_t Index(int ix, int iy) {
    return static_cast<std::size_t>(iy) * kColumns + static_cast<std::size_t>(ix);
  }
  static int Cell(double u, int count) { return static_cast<int>(std::clamp(u, 0.0, count - 2.0)); }

  double spacing_, inverse_;
  std::vector<double> nodes_;
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

std::shared_ptr<const Ground> MakeBumpGround(double x, double radius) {
  return std::make_shared<BumpGround>(x, radius);
}

std::shared_ptr<const Ground> MakeSineGround(double x_begin, double x_end, double amplitude,
                                             double wavelength) {
  return std::make_shared<SineGround>(x_begin, x_end, amplitude, wavelength);
}

std::shared_ptr<const Ground> MakeRandomGround(double x_begin, double amplitude, double spacing,
                                               std::uint64_t seed) {
  return std::make_shared<RandomGround>(x_begin, amplitude, spacing, seed);
}

std::shared_ptr<const Ground> MakePlaneGround(double grade_x, double grade_y,
                                              const SoilSample& soil) {
  return std::make_shared<PlaneGround>(grade_x, grade_y, soil);
}

}  // namespace dbd
