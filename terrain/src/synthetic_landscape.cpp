#include "synthetic_landscape.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

// Independent noise fields; hills and patches take as many numbers as they have octaves.
enum Channel { kHills = 0, kCourse = 20, kMeander = 21, kFords = 22, kPatches = 30 };

constexpr double kLowestGround = 300.0;  // about, above sea level [m]
constexpr int kHillOctaves = 6;
constexpr double kHillGain = 0.35;
constexpr double kBrookDepth = 1.2;        // [m]
constexpr double kFordRun = 8.0;           // length of a ford's bank [m]
constexpr double kFordSpacing = 90.0;      // about [m]
constexpr double kMeanderLength = 70.0;    // [m]
constexpr double kMeanderAmplitude = 9.0;  // [m]
constexpr double kTrenchDepth = 4.0;       // [m]
constexpr double kTrenchRadius = 25.0;     // of its middle [m]
constexpr double kTrenchWidth = 5.0;       // [m]

double SmoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

HeightMap::Grid GridOf(const GeneratorOptions& options) {
  HeightMap::Grid grid;
  grid.columns = options.size;
  grid.rows = options.size;
  grid.cell_size = Eigen::Vector2d::Constant(options.cell_size);
  grid.first_center = 0.5 * grid.cell_size;
  return grid;
}

}  // namespace

const char* SoilName(Soil soil) {
  switch (soil) {
    case Soil::kFirm:
      return "firm-soil";
    case Soil::kTilled:
      return "tilled-soil";
    case Soil::kSoft:
      return "soft-soil";
    case Soil::kVerySoft:
      return "very-soft-soil";
  }
  DBD_ASSERT(false);
}

SyntheticLandscape::SyntheticLandscape(const GeneratorOptions& options)
    : options_(options),
      noise_(options.seed),
      grid_(GridOf(options)),
      center_(Eigen::Vector2d::Constant(0.5 * options.size * options.cell_size)),
      extent_(options.size * options.cell_size),
      brook_half_width_(std::max(1.5, options.cell_size)),
      bank_run_(std::max(1.2, options.cell_size)),
      heights_(grid_, MakeHeights(), kLowestGround),
      soils_(MakeSoils()) {}

Soil SyntheticLandscape::SoilAt(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d cell = place / options_.cell_size;
  const int column = std::clamp(static_cast<int>(cell.x()), 0, grid_.columns - 1);
  const int row = std::clamp(static_cast<int>(cell.y()), 0, grid_.rows - 1);
  return soils_[static_cast<std::size_t>(row) * grid_.columns + column];
}

double SyntheticLandscape::trench_outer_radius() const {
  return options_.walled_goal ? kTrenchRadius + 0.5 * kTrenchWidth : 0.0;
}

// Hills scaled to the relief, lowered towards the brook's valley, then cut by brook and trench.
std::vector<float> SyntheticLandscape::MakeHeights() const {
  std::vector<float> heights(grid_.CellCount());
  const auto for_each = [&](auto&& visit) {
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) {
        visit(heights[static_cast<std::size_t>(row) * grid_.columns + column],
              grid_.Center(column, row));
      }
    }
  };
  const double valley_width = 0.4 * options_.wavelength;
  for_each([&](float& height, const Eigen::Vector2d& place) {
    const Eigen::Vector2d scaled = place / options_.wavelength;
    const double hill = noise_.Fractal(scaled.x(), scaled.y(), kHillOctaves, kHillGain, kHills);
    const double in_valley = std::exp(-std::pow(BrookDistance(place) / valley_width, 2));
    height = static_cast<float>(hill + in_valley * 0.5 * (-0.35 - hill));
  });
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const double base = *lowest;
  const double scale = options_.relief / (double{*highest} - *lowest);
  for_each([&](float& height, const Eigen::Vector2d& place) {
    const double hills = (height - base) * scale;
    height = static_cast<float>(hills - BrookDepth(place) - TrenchDepth(place));
  });
  return heights;
}

// The brook crosses the map from west to east in its southern half and meanders.
SyntheticLandscape::Course SyntheticLandscape::CourseAt(double x) const {
  const auto y_at = [this](double place_x) {
    const double bend = noise_.Gradient(1.5 * place_x / extent_, 0.5, kCourse);
    const double meander = noise_.Gradient(place_x / kMeanderLength, 0.5, kMeander);
    return extent_ * (0.33 + 0.1 * bend) + std::min(kMeanderAmplitude, 0.05 * extent_) * meander;
  };
  constexpr double kStep = 0.5;
  return {y_at(x), (y_at(x + kStep) - y_at(x - kStep)) / (2 * kStep)};
}

double SyntheticLandscape::BrookDistance(const Eigen::Vector2d& place) const {
  const Course course = CourseAt(place.x());
  return std::abs(place.y() - course.y) / std::hypot(1.0, course.slope);
}

// Banks are steep, and gentle at the fords.
double SyntheticLandscape::BrookDepth(const Eigen::Vector2d& place) const {
  const double ford =
      SmoothStep(3 * noise_.Gradient(2 * place.x() / kFordSpacing, 0.5, kFords) + 0.3);
  const double run = bank_run_ + ford * kFordRun;
  const double up_the_bank = (BrookDistance(place) - brook_half_width_) / run;
  return kBrookDepth * (1 - 0.4 * ford) * (1 - SmoothStep(up_the_bank));
}

// At least two cells wide, so that bilinear heights keep its full depth.
double SyntheticLandscape::TrenchDepth(const Eigen::Vector2d& place) const {
  if (!options_.walled_goal) return 0;
  const double cell = options_.cell_size;
  const double width = std::max(kTrenchWidth, 3 * cell);
  const double radius = std::max(kTrenchRadius, 6 * cell);
  const bool inside = std::abs((place - center_).norm() - radius) <= 0.5 * width;
  return inside ? kTrenchDepth * std::max(1.0, cell) : 0;
}

std::vector<Soil> SyntheticLandscape::MakeSoils() const {
  std::vector<Soil> soils(grid_.CellCount());
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      const Eigen::Vector2d place = grid_.Center(column, row);
      const double patch = noise_.Fractal(place.x() / 45, place.y() / 45, 2, 0.5, kPatches);
      const double height =
          (heights_.CellHeight(column, row) - heights_.lowest()) / std::max(options_.relief, 1.0);
      const double distance = BrookDistance(place) - brook_half_width_;
      Soil& soil = soils[static_cast<std::size_t>(row) * grid_.columns + column];
      if (distance < 1.0) {
        soil = Soil::kVerySoft;
      } else if (distance < 8 + 12 * patch) {
        soil = Soil::kSoft;
      } else if (height < 0.4 + 0.5 * patch) {
        soil = Soil::kTilled;
      } else {
        soil = Soil::kFirm;
      }
    }
  }
  return soils;
}

// Steepest of the rises to the places 3 m around [-].
double SyntheticLandscape::Slope(const Eigen::Vector2d& place) const {
  constexpr double kReach = 3.0;
  const double here = heights_.Height(place.x(), place.y());
  double steepest = 0;
  for (const Eigen::Vector2d& step : {Eigen::Vector2d(kReach, 0), Eigen::Vector2d(0, kReach)}) {
    for (const Eigen::Vector2d& there :
         {Eigen::Vector2d(place + step), Eigen::Vector2d(place - step)}) {
      const double rise = heights_.Height(there.x(), there.y()) - here;
      steepest = std::max(steepest, std::abs(rise) / kReach);
    }
  }
  return steepest;
}

Eigen::Vector2d SyntheticLandscape::FlattestPlace(const Eigen::Vector2d& around,
                                                  double radius) const {
  constexpr int kSteps = 12;
  Eigen::Vector2d best = around;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Eigen::Vector2d place = around + Eigen::Vector2d(i, j) * (radius / kSteps);
      const bool is_dry = SoilAt(place) == Soil::kFirm || SoilAt(place) == Soil::kTilled;
      const double cost = Slope(place) + (is_dry ? 0.0 : 10.0);
      if (cost < least) {
        least = cost;
        best = place;
      }
    }
  }
  return best;
}

}  // namespace dbd
