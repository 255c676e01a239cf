#pragma once

#include <dbd/terrain/height_map.h>

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// The window of W that a picture shows, north up. Pixel (0, 0) is its north-west corner and y
/// grows to the south.
struct MapView {
  Eigen::Vector2d north_west = Eigen::Vector2d::Zero();  ///< [m] in W
  double pixel_size = 1;                                 ///< [m]
  int width = 0;                                         ///< [pixels]
  int height = 0;

  Eigen::Vector2d ToPixel(const Eigen::Vector2d& local) const;
  Eigen::Vector2d ToLocal(const Eigen::Vector2d& pixel) const;
};

/// A window `width` pixels wide round `points` with a margin, kept inside the map where it fits;
/// the whole map when the points spread over most of it. Without points: the whole map.
MapView FitView(const HeightMap& heights, const std::vector<Eigen::Vector2d>& points, int width);

}  // namespace dbd
