#include <dbd/planner/extra_cost.h>

#include <algorithm>
#include <cmath>

namespace dbd {

ExtraCost::ExtraCost(const Eigen::Vector2d& min_corner, const Eigen::Vector2d& max_corner,
                     double cell)
    : min_corner_(min_corner),
      cell_(cell),
      columns_(static_cast<int>((max_corner.x() - min_corner.x()) / cell) + 1),
      rows_(static_cast<int>((max_corner.y() - min_corner.y()) / cell) + 1),
      values_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0f) {}

/// Calls change(value, height) for all cells under the cone. Its section through the middle is a
/// triangle of base 2 r and height h, so that h r = `seconds`.
template <typename Change>
void ExtraCost::ForCone(const Eigen::Vector2d& place, double radius, double seconds,
                        const Change& change) {
  const Eigen::Array2d first = ((place - min_corner_).array() - radius) / cell_ - 0.5;
  const Eigen::Array2d last = ((place - min_corner_).array() + radius) / cell_ - 0.5;
  const auto begin = [](double index) { return std::max(0, static_cast<int>(std::ceil(index))); };
  for (int row = begin(first.y()); row < rows_ && row <= last.y(); ++row) {
    for (int column = begin(first.x()); column < columns_ && column <= last.x(); ++column) {
      const Eigen::Vector2d center =
          min_corner_ + cell_ * (Eigen::Vector2d(column, row).array() + 0.5).matrix();
      const double share = 1 - (center - place).norm() / radius;
      const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                static_cast<std::size_t>(column);
      if (share > 0) change(values_[index], static_cast<float>(share * seconds / radius));
    }
  }
}

void ExtraCost::AddCone(const Eigen::Vector2d& place, double radius, double seconds) {
  ForCone(place, radius, seconds, [](float& value, float height) { value += height; });
}

void ExtraCost::RaiseToCone(const Eigen::Vector2d& place, double radius, double seconds) {
  ForCone(place, radius, seconds,
          [](float& value, float height) { value = std::max(value, height); });
}

void ExtraCost::Add(const ExtraCost& other) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] += other.values_[i];
}

int ExtraCost::IndexOf(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d cells = (place - min_corner_) / cell_;
  const bool inside = cells.x() >= 0 && cells.y() >= 0 && cells.x() < columns_ && cells.y() < rows_;
  return inside ? static_cast<int>(cells.y()) * columns_ + static_cast<int>(cells.x()) : -1;
}

void ExtraCost::AddAt(const Eigen::Vector2d& place, double seconds_per_metre) {
  const int index = IndexOf(place);
  if (index >= 0) values_[static_cast<std::size_t>(index)] += static_cast<float>(seconds_per_metre);
}

double ExtraCost::Value(int column, int row) const {
  column = std::clamp(column, 0, columns_ - 1);
  row = std::clamp(row, 0, rows_ - 1);
  return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)];
}

double ExtraCost::SecondsPerMetre(double x, double y) const {
  if (IndexOf({x, y}) < 0) return 0;
  const double u = (x - min_corner_.x()) / cell_ - 0.5, v = (y - min_corner_.y()) / cell_ - 0.5;
  const double left = std::floor(u), below = std::floor(v);
  const auto column = static_cast<int>(left), row = static_cast<int>(below);
  const double south =
      Value(column, row) + (u - left) * (Value(column + 1, row) - Value(column, row));
  const double north =
      Value(column, row + 1) + (u - left) * (Value(column + 1, row + 1) - Value(column, row + 1));
  return south + (v - below) * (north - south);
}

}  // namespace dbd
