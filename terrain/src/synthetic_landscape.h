#pragma once

#include <dbd/terrain/generator.h>
#include <dbd/terrain/height_map.h>

#include <cstdint>
#include <vector>

#include "hash_noise.h"

namespace dbd {

/// Names in the built-in material table "basic".
enum class Soil : std::uint8_t { kFirm, kTilled, kSoft, kVerySoft };
const char* SoilName(Soil soil);

/// Ground and soil of a generated terrain, in metres from the map's south-west corner.
class SyntheticLandscape {
 public:
  explicit SyntheticLandscape(const GeneratorOptions& options);

  const HeightMap& heights() const { return heights_; }
  /// rows x columns, row 0 south.
  const std::vector<Soil>& soils() const { return soils_; }
  Soil SoilAt(const Eigen::Vector2d& place) const;

  double BrookDistance(const Eigen::Vector2d& place) const;
  /// Width of the brook's bed and banks, half of it [m].
  double brook_half_width() const { return brook_half_width_; }
  /// Radius of the trench's outer edge, 0 when there is none [m].
  double trench_outer_radius() const;
  Eigen::Vector2d center() const { return center_; }

  /// Flattest dry place within `radius`.
  Eigen::Vector2d FlattestPlace(const Eigen::Vector2d& around, double radius) const;

 private:
  struct Course {
    double y;      // of the brook's middle [m]
    double slope;  // dy/dx [-]
  };

  std::vector<float> MakeHeights() const;
  Course CourseAt(double x) const;
  double BrookDepth(const Eigen::Vector2d& place) const;
  double TrenchDepth(const Eigen::Vector2d& place) const;
  std::vector<Soil> MakeSoils() const;
  double Slope(const Eigen::Vector2d& place) const;

  GeneratorOptions options_;
  HashNoise noise_;
  HeightMap::Grid grid_;
  Eigen::Vector2d center_;
  double extent_;
  double brook_half_width_;
  double bank_run_;  // of the steepest bank [m]
  HeightMap heights_;
  std::vector<Soil> soils_;
};

}  // namespace dbd
