#include "relief.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dbd {
namespace {

/// Heights at pixel centres, with a border wide enough for the gradient.
class HeightSamples {
 public:
  HeightSamples(const Terrain& terrain, const MapView& view)
      : border_(Border(terrain.heights(), view)),
        columns_(view.width + 2 * border_),
        spacing_(border_ * view.pixel_size),
        heights_(static_cast<std::size_t>(columns_) * (view.height + 2 * border_)) {
    tbb::parallel_for(0, view.height + 2 * border_, [&](int row) {
      std::vector<double> x(columns_), y(columns_);
      for (int column = 0; column < columns_; ++column) {
        const Eigen::Vector2d place = view.ToLocal({column - border_ + 0.5, row - border_ + 0.5});
        x[column] = place.x();
        y[column] = place.y();
      }
      terrain.Heights(columns_, x.data(), y.data(),
                      &heights_[static_cast<std::size_t>(row) * columns_]);
    });
  }

  double At(int column, int row) const {
    return heights_[static_cast<std::size_t>(row + border_) * columns_ + column + border_];
  }

  /// Slope to the east and to the north [-] by Horn's weights: B. K. P. Horn, "Hill shading and
  /// the reflectance map", Proc. IEEE 69 (1981).
  Eigen::Vector2d Gradient(int column, int row) const {
    const int d = border_;
    const auto z = [&](int i, int j) { return At(column + i * d, row + j * d); };
    const double east = z(1, -1) + 2 * z(1, 0) + z(1, 1) - z(-1, -1) - 2 * z(-1, 0) - z(-1, 1);
    const double north = z(-1, -1) + 2 * z(0, -1) + z(1, -1) - z(-1, 1) - 2 * z(0, 1) - z(1, 1);
    return Eigen::Vector2d(east, north) / (8 * spacing_);
  }

 private:
  /// Neighbours nearer than a cell would show the facets of the bilinear surface.
  static int Border(const HeightMap& heights, const MapView& view) {
    const double cell = heights.grid().cell_size.maxCoeff();
    return std::clamp(static_cast<int>(std::lround(cell / view.pixel_size)), 1, 64);
  }

  int border_;
  int columns_;
  double spacing_;
  std::vector<double> heights_;
};

/// What the picture as a whole decides: the span of the tint, exaggeration, contours.
struct Tones {
  double low = 0;
  double high = 1;
  double exaggeration = 1;
  double contour_interval = 0;
};

double ContourInterval(double span) {
  for (const double interval : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
    if (span / interval <= 20) return interval;
  }
  return 0;
}

Tones ChooseTones(const HeightSamples& samples, const MapView& view) {
  std::vector<double> heights;
  double slope_squares = 0;
  const int step = std::max(1, view.width / 200);
  for (int row = 0; row < view.height; row += step) {
    for (int column = 0; column < view.width; column += step) {
      heights.push_back(samples.At(column, row));
      slope_squares += samples.Gradient(column, row).squaredNorm();
    }
  }
  const double rms_slope = std::sqrt(slope_squares / static_cast<double>(heights.size()));
  std::sort(heights.begin(), heights.end());
  Tones tones;
  tones.low = heights[heights.size() / 100];
  tones.high = std::max(heights[heights.size() - 1 - heights.size() / 100], tones.low + 1.0);
  // Gentle land is exaggerated until its relief can be seen.
  tones.exaggeration = std::clamp(0.35 / std::max(rms_slope, 0.01), 1.0, 6.0);
  tones.contour_interval = ContourInterval(tones.high - tones.low);
  return tones;
}

Color Tint(double share) {
  static constexpr std::array<Color, 5> kRamp = {Hex(0xb3cfa8), Hex(0xd9dfb4), Hex(0xecdcb0),
                                                 Hex(0xd9ba92), Hex(0xf1e8df)};
  const double at = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
  return Mix(kRamp[below], kRamp[below + 1], at - static_cast<double>(below));
}

/// A light far off, by where it stands.
struct Light {
  Light(double azimuth_deg, double altitude_deg)
      : to_light(std::sin(azimuth_deg * std::numbers::pi / 180),
                 std::cos(azimuth_deg * std::numbers::pi / 180)),
        sin_altitude(std::sin(altitude_deg * std::numbers::pi / 180)),
        cos_altitude(std::cos(altitude_deg * std::numbers::pi / 180)) {}

  Eigen::Vector2d to_light;
  double sin_altitude;
  double cos_altitude;
};

/// Lambert shading by one light, 1 on level ground. `steepness`: the length of the ground's normal
/// whose vertical part is 1.
double Shade(const Eigen::Vector2d& gradient, double steepness, const Light& light) {
  const double lit = light.sin_altitude - light.cos_altitude * gradient.dot(light.to_light);
  return std::max(0.0, lit) / steepness / light.sin_altitude;
}

Color Lit(const Color& color, const Eigen::Vector2d& gradient) {
  static const Light north_west(315, 45), west(270, 50), north(0, 60);
  const double steepness = std::sqrt(1 + gradient.squaredNorm());
  const double shade = 0.65 * Shade(gradient, steepness, north_west) +
                       0.2 * Shade(gradient, steepness, west) +
                       0.15 * Shade(gradient, steepness, north);
  if (shade < 1) return Mix(Hex(0x2b2f45), color, 0.25 + 0.75 * shade);
  return Mix(color, Hex(0xffffff), std::min(0.6, 0.8 * (shade - 1)));
}

/// How much of a pixel a contour line covers: its distance in heights over the height per pixel.
double ContourCover(const Tones& tones, double height, double slope, double pixel_size) {
  if (tones.contour_interval <= 0 || slope < 0.02) return 0;
  const double distance =
      std::abs(std::remainder(height, tones.contour_interval)) / (slope * pixel_size);
  return std::clamp(1.1 - distance, 0.0, 1.0);
}

std::vector<const Material*> MaterialsInView(const MaterialMap& map, const MapView& view) {
  if (map.is_uniform()) return {};
  const std::vector<Material>& table = map.table().materials();
  std::vector<bool> seen(table.size(), false);
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Eigen::Vector2d place = view.ToLocal({column + 0.5, row + 0.5});
      const Material* material = map.At(place.x(), place.y());
      if (material) seen[static_cast<std::size_t>(material - table.data())] = true;
    }
  }
  std::vector<const Material*> materials;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (seen[i]) materials.push_back(&table[i]);
  }
  return materials;
}

class ReliefPainter {
 public:
  ReliefPainter(const Terrain& terrain, const MapView& view, double obstacle_height)
      : terrain_(terrain),
        view_(view),
        obstacle_height_(obstacle_height),
        samples_(terrain, view),
        tones_(ChooseTones(samples_, view)),
        materials_(MaterialsInView(terrain.materials(), view)) {}

  double contour_interval() const { return tones_.contour_interval; }
  const std::vector<const Material*>& materials() const { return materials_; }

  Color At(int column, int row) const {
    const Eigen::Vector2d place = view_.ToLocal({column + 0.5, row + 0.5});
    if (!terrain_.IsKnown(place.x(), place.y())) {
      return (column + row) % 9 == 0 ? kHatchColor : kUnknownColor;
    }
    const double height = samples_.At(column, row);
    const Eigen::Vector2d gradient = samples_.Gradient(column, row);
    const Color ground = Soil(place, Tint((height - tones_.low) / (tones_.high - tones_.low)));
    const Color lit = Lit(ground, gradient * tones_.exaggeration);
    const double contour = ContourCover(tones_, height, gradient.norm(), view_.pixel_size);
    const Color lined = Mix(lit, Hex(0x5b4636), 0.28 * contour);
    return terrain_.obstacles().Blocks(place.x(), place.y(), obstacle_height_)
               ? Mix(lined, kObstacleColor, 0.75)
               : lined;
  }

 private:
  Color Soil(const Eigen::Vector2d& place, const Color& tint) const {
    if (materials_.empty()) return tint;
    const Material* material = terrain_.materials().At(place.x(), place.y());
    if (!material) return tint;
    const auto found = std::find(materials_.begin(), materials_.end(), material);
    const auto index = static_cast<std::size_t>(found - materials_.begin());
    return Mix(tint, MaterialTint(*material, index), material->passable ? 0.45 : 0.75);
  }

  const Terrain& terrain_;
  const MapView& view_;
  double obstacle_height_;
  HeightSamples samples_;
  Tones tones_;
  std::vector<const Material*> materials_;
};

std::uint32_t Pixel(const Color& color) {
  const auto part = [](double value) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return 0xff000000u | part(color.red) << 16 | part(color.green) << 8 | part(color.blue);
}

}  // namespace

Color MaterialTint(const Material& material, std::size_t place) {
  static constexpr std::array<unsigned, 8> kColors = {0xe6cf8b, 0x7fb069, 0xb07d4f, 0xd9a5b3,
                                                      0x8aa6a3, 0xc9c27a, 0x9c8fc0, 0xb5b5b5};
  return material.passable ? Hex(kColors[place % kColors.size()]) : kImpassableColor;
}

ReliefImage RenderRelief(const Terrain& terrain, const MapView& view, double obstacle_height) {
  const ReliefPainter painter(terrain, view, obstacle_height);
  ReliefImage image{view.width, view.height, {}, painter.contour_interval(), painter.materials()};
  image.pixels.resize(static_cast<std::size_t>(view.width) * view.height);
  tbb::parallel_for(0, view.height, [&](int row) {
    std::uint32_t* line = &image.pixels[static_cast<std::size_t>(row) * view.width];
    for (int column = 0; column < view.width; ++column) {
      line[column] = Pixel(painter.At(column, row));
    }
  });
  return image;
}

}  // namespace dbd
