#include "map_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

using Box = Eigen::AlignedBox2d;

constexpr double kLeastMargin = 15.0;  // [m]
constexpr double kMarginShare = 0.12;
// A window at least this share of the map's side might as well show all of it.
constexpr double kNearlyAll = 0.8;
constexpr double kLeastAspect = 0.5;  // height / width
constexpr double kMostAspect = 1.0;

Box WithMargin(const std::vector<Eigen::Vector2d>& points) {
  Box box;
  for (const Eigen::Vector2d& point : points) box.extend(point);
  const double margin = std::max(kLeastMargin, kMarginShare * box.sizes().maxCoeff());
  return Box(box.min().array() - margin, box.max().array() + margin);
}

Box WithAspect(const Box& box) {
  const double width = std::max(box.sizes().x(), box.sizes().y() / kMostAspect);
  const double height = std::max(box.sizes().y(), width * kLeastAspect);
  const Eigen::Vector2d half(width / 2, height / 2);
  return Box(box.center() - half, box.center() + half);
}

/// Moves the window inside the map in each direction in which it fits, else centres it there.
Box MovedInside(const Box& box, const Box& map) {
  Eigen::Vector2d shift;
  for (int i = 0; i < 2; ++i) {
    const double low = map.min()[i] - box.min()[i];
    const double high = map.max()[i] - box.max()[i];
    shift[i] = low <= high ? std::clamp(0.0, low, high) : (low + high) / 2;
  }
  return Box(box.min() + shift, box.max() + shift);
}

}  // namespace

Eigen::Vector2d MapView::ToPixel(const Eigen::Vector2d& local) const {
  return {(local.x() - north_west.x()) / pixel_size, (north_west.y() - local.y()) / pixel_size};
}

Eigen::Vector2d MapView::ToLocal(const Eigen::Vector2d& pixel) const {
  return {north_west.x() + pixel.x() * pixel_size, north_west.y() - pixel.y() * pixel_size};
}

MapView FitView(const HeightMap& heights, const std::vector<Eigen::Vector2d>& points, int width) {
  const Box map(heights.min_corner(), heights.max_corner());
  Box box = points.empty() ? map : WithMargin(points).intersection(map);
  if ((box.sizes().array() >= kNearlyAll * map.sizes().array()).all()) box = map;
  box = MovedInside(WithAspect(box), map);
  MapView view;
  view.north_west = {box.min().x(), box.max().y()};
  view.pixel_size = box.sizes().x() / width;
  view.width = width;
  view.height = static_cast<int>(std::ceil(box.sizes().y() / view.pixel_size - 1e-9));
  return view;
}

}  // namespace dbd
