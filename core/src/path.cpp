#include <dbd/core/path.h>

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dbd {

Path::Path(const std::vector<Eigen::Vector2d>& points, const std::vector<bool>& reverse) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i];
    if (!p.allFinite()) throw InputError("path: a point has a coordinate that is not a number");
    if (points_.empty()) {
      points_.push_back(p);
      arc_lengths_.push_back(0);
      continue;
    }
    const double step = (p - points_.back()).norm();
    if (step < 1e-6) continue;
    points_.push_back(p);
    arc_lengths_.push_back(arc_lengths_.back() + step);
    AddStretch(arc_lengths_.end()[-2], arc_lengths_.back(), i < reverse.size() && reverse[i]);
  }
  if (points_.size() < 2) throw InputError("path: needs at least two distinct points");
}

void Path::AddStretch(double begin, double end, bool reverse) {
  if (stretches_.empty() || stretches_.back().reverse != reverse) {
    stretches_.push_back({begin, end, reverse});
  }
  stretches_.back().end = end;
}

const PathStretch& Path::StretchAt(double s) const {
  std::size_t i = 0;
  while (i + 1 < stretches_.size() && s >= stretches_[i].end) ++i;
  return stretches_[i];
}

double Path::reverse_length() const {
  double length = 0;
  for (const PathStretch& stretch : stretches_) {
    if (stretch.reverse) length += stretch.end - stretch.begin;
  }
  return length;
}

/// Points are mostly about evenly spaced: looks first where s would be if they were.
std::size_t Path::SegmentAt(double s) const {
  constexpr std::size_t kNear = 4;
  const std::size_t last = points_.size() - 2;
  const double share = s > 0 ? std::min(s / length(), 1.0) : 0;  // 0 for what is no number
  const auto guess = static_cast<std::size_t>(share * static_cast<double>(last));
  const std::size_t low = guess - std::min(guess, kNear), high = std::min(last, guess + kNear);
  if (arc_lengths_[low] <= s && s < arc_lengths_[high]) {
    std::size_t i = low;
    while (arc_lengths_[i + 1] <= s) ++i;
    return i;
  }
  const auto next = std::upper_bound(arc_lengths_.begin(), arc_lengths_.end(), s);
  const auto index = std::distance(arc_lengths_.begin(), next) - 1;
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(last)));
}

Eigen::Vector2d Path::Position(double s) const {
  const std::size_t i = SegmentAt(s);
  const double t = (s - arc_lengths_[i]) / (arc_lengths_[i + 1] - arc_lengths_[i]);
  return points_[i] + t * (points_[i + 1] - points_[i]);
}

Eigen::Vector2d Path::PositionOn(const PathStretch& stretch, double s) const {
  if (s <= stretch.end || stretch.end >= length()) return Position(s);
  const std::size_t i = SegmentAt(stretch.end) - 1;  // the stretch's last
  const Eigen::Vector2d ahead = (points_[i + 1] - points_[i]).normalized();
  return points_[i + 1] + (s - stretch.end) * ahead;
}

double Path::Heading(double s) const {
  const std::size_t i = SegmentAt(s);
  const Eigen::Vector2d d = points_[i + 1] - points_[i];
  return std::atan2(d.y(), d.x());
}

double Path::VehicleHeading(double s) const {
  if (!StretchAt(s).reverse) return Heading(s);
  return std::remainder(Heading(s) + std::numbers::pi, 2 * std::numbers::pi);
}

double Path::Curvature(double s, double half_window) const {
  const PathStretch& stretch = StretchAt(s);
  const double a = std::max(stretch.begin, s - half_window);
  const double b = std::min(stretch.end, s + half_window);
  if (b - a < 1e-6) return 0;
  // At the end of a stretch that is not the last, the heading there is already that of the next.
  const double before_end = b < length() ? std::min(b, std::nextafter(stretch.end, a)) : b;
  const double turn = std::remainder(Heading(before_end) - Heading(a), 2 * std::numbers::pi);
  return turn / (b - a);
}

double Path::NearestArcLength(const Eigen::Vector2d& p, double s_from, double s_to) const {
  double best_s = s_from;
  double best_distance = std::numeric_limits<double>::infinity();
  double within = best_distance;  // as a length, and a little more against round-off
  for (std::size_t i = SegmentAt(s_from); i + 1 < points_.size(); ++i) {
    if (arc_lengths_[i] > s_to) break;
    const double segment = arc_lengths_[i + 1] - arc_lengths_[i];
    const double reach = within + segment;
    if ((p - points_[i]).squaredNorm() > reach * reach) continue;  // all of it is farther
    const Eigen::Vector2d d = points_[i + 1] - points_[i];
    const double along = (p - points_[i]).dot(d) / segment;
    const double s = std::clamp(arc_lengths_[i] + std::clamp(along, 0.0, segment), s_from, s_to);
    const Eigen::Vector2d q = points_[i] + (s - arc_lengths_[i]) / segment * d;
    const double distance = (q - p).squaredNorm();
    if (distance >= best_distance) continue;
    best_distance = distance, best_s = s;
    within = (1 + 1e-9) * std::sqrt(distance);
  }
  return best_s;
}

}  // namespace dbd
