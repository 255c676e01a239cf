#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

double SquaredDistanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared_length = along.squaredNorm();
  const double t =
      squared_length > 0 ? std::clamp((p - a).dot(along) / squared_length, 0.0, 1.0) : 0.0;
  return (a + t * along - p).squaredNorm();
}

// Of the points of a polyline from another, or `bound` when it is not less. Sums only grow, so that
// neighbours on the same side far off settle it after a few points.
double MeanDistanceUpTo(double bound, const std::vector<Eigen::Vector2d>& from,
                        const std::vector<Eigen::Vector2d>& to) {
  const auto count = static_cast<double>(from.size());
  double sum = 0;
  for (const Eigen::Vector2d& p : from) {
    sum += DistanceToPolyline(p, to);
    if (sum / count >= bound) return bound;
  }
  return sum / count;
}

}  // namespace

std::vector<Eigen::Vector2d> Thin(const std::vector<Eigen::Vector2d>& points, double spacing) {
  std::vector<Eigen::Vector2d> kept;
  double since_last = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) since_last += (points[i] - points[i - 1]).norm();
    if (since_last < spacing && i + 1 < points.size()) continue;
    kept.push_back(points[i]);
    since_last = 0;
  }
  return kept;
}

double Separation(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  return SeparationUpTo(std::numeric_limits<double>::infinity(), a, b);
}

double SeparationUpTo(double bound, const std::vector<Eigen::Vector2d>& a,
                      const std::vector<Eigen::Vector2d>& b) {
  const double one = MeanDistanceUpTo(bound, a, b);
  return one >= bound ? bound : std::max(one, MeanDistanceUpTo(bound, b, a));
}

std::vector<double> NearestSeparations(const std::vector<std::vector<Eigen::Vector2d>>& lines) {
  std::vector<double> nearest(lines.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double bound = std::max(nearest[i], nearest[j]);
      const double separation = SeparationUpTo(bound, lines[i], lines[j]);
      nearest[i] = std::min(nearest[i], separation);
      nearest[j] = std::min(nearest[j], separation);
    }
  }
  return nearest;
}

double DistanceToPolyline(const Eigen::Vector2d& point,
                          const std::vector<Eigen::Vector2d>& polyline) {
  double nearest = (point - polyline.front()).squaredNorm();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    nearest = std::min(nearest, SquaredDistanceToSegment(point, polyline[i], polyline[i + 1]));
  }
  return std::sqrt(nearest);
}

}  // namespace dbd
