#pragma once

#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <stop_token>
#include <vector>

namespace dbd {

/// What the way from a place to a goal costs a vehicle that turns on the spot [s]: least costs over
/// square cells and their eight neighbours. Cells that are no-go can be passed at a high price, so
/// that there is a cost everywhere in the region.
class CostToGoField {
 public:
  /// Over the rectangle between the corners [m, W]; cells are as large as the layer's, larger when
  /// there would be too many. Throws StopRequested soon after `stop` was asked to.
  CostToGoField(const TrafficabilityLayer& layer, const Eigen::Vector2d& goal,
                const Eigen::Vector2d& min_corner, const Eigen::Vector2d& max_corner,
                const std::stop_token& stop);

  /// Cost at the nearest cell [s]; infinite outside the region.
  double At(double x, double y) const;

 private:
  bool Inside(int column, int row) const;
  std::size_t Slot(int column, int row) const;
  void Spread(const TrafficabilityLayer& layer, const Eigen::Vector2d& goal,
              const std::stop_token& stop);

  Eigen::Vector2d min_corner_;
  double cell_ = 1;  // [m]
  int columns_ = 1;
  int rows_ = 1;
  std::vector<double> cost_;
};

}  // namespace dbd
