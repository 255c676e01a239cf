#pragma once

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// Cost of travel that comes on top of the trafficability layer's [s/m]: a grid of square cells,
/// bilinear between their centres, nothing outside.
class ExtraCost {
 public:
  ExtraCost(const Eigen::Vector2d& min_corner, const Eigen::Vector2d& max_corner, double cell);

  /// A cone round a place that costs `seconds` to cross through its middle: on top of what is
  /// there, or where it is higher than that.
  void AddCone(const Eigen::Vector2d& place, double radius, double seconds);
  void RaiseToCone(const Eigen::Vector2d& place, double radius, double seconds);

  /// `other` must be of the same shape.
  void Add(const ExtraCost& other);

  /// Adds to the cell of a place [s/m].
  void AddAt(const Eigen::Vector2d& place, double seconds_per_metre);

  double SecondsPerMetre(double x, double y) const;

  double cell() const { return cell_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Of the cell that a place is in; -1 outside.
  int IndexOf(const Eigen::Vector2d& place) const;

 private:
  template <typename Change>
  void ForCone(const Eigen::Vector2d& place, double radius, double seconds, const Change& change);
  double Value(int column, int row) const;

  Eigen::Vector2d min_corner_;
  double cell_;
  int columns_;
  int rows_;
  std::vector<float> values_;  // at the cells' centres [s/m]
};

}  // namespace dbd
