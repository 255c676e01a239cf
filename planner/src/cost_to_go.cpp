#include "cost_to_go.h"

#include <dbd/planner/stop.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace dbd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostCells = 200'000;
constexpr double kBlocked = 10.0;  // [s/m] dearer than any detour, but not impossible
constexpr int kMoves = 8;
constexpr std::array<int, kMoves> kColumnStep{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, kMoves> kRowStep{0, 1, 1, 1, 0, -1, -1, -1};

}  // namespace

CostToGoField::CostToGoField(const TrafficabilityLayer& layer, const Eigen::Vector2d& goal,
                             const Eigen::Vector2d& min_corner, const Eigen::Vector2d& max_corner,
                             const std::stop_token& stop)
    : min_corner_(min_corner.cwiseMax(layer.min_corner())) {
  const Eigen::Vector2d extent = max_corner.cwiseMin(layer.max_corner()) - min_corner_;
  cell_ = std::max(layer.resolution(), std::sqrt(std::max(0.0, extent.prod()) / kMostCells));
  columns_ = std::max(1, static_cast<int>(extent.x() / cell_) + 1);
  rows_ = std::max(1, static_cast<int>(extent.y() / cell_) + 1);
  cost_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kInfinity);
  Spread(layer, goal, stop);
}

void CostToGoField::Spread(const TrafficabilityLayer& layer, const Eigen::Vector2d& goal,
                           const std::stop_token& stop) {
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const Eigen::Vector2d cells = (goal - min_corner_) / cell_;
  const int first_column = static_cast<int>(std::lround(cells.x()));
  const int first_row = static_cast<int>(std::lround(cells.y()));
  if (!Inside(first_column, first_row)) return;
  cost_[Slot(first_column, first_row)] = 0;
  open.push({0, Slot(first_column, first_row)});
  while (!open.empty()) {
    const auto [cost, slot] = open.top();
    open.pop();
    if (cost > cost_[slot]) continue;
    ThrowIfStopped(stop);
    const int column = static_cast<int>(slot % static_cast<std::size_t>(columns_));
    const int row = static_cast<int>(slot / static_cast<std::size_t>(columns_));
    const double x = min_corner_.x() + column * cell_, y = min_corner_.y() + row * cell_;
    for (int move = 0; move < kMoves; ++move) {
      // The vehicle comes from the neighbour to this cell.
      const int from_column = column - kColumnStep[move], from_row = row - kRowStep[move];
      if (!Inside(from_column, from_row)) continue;
      const double rate = layer.SecondsPerMetre(x, y, move * std::numbers::pi / 4);
      const double length = cell_ * std::hypot(kColumnStep[move], kRowStep[move]);
      const double reached = cost + length * std::min(rate, kBlocked);
      double& present = cost_[Slot(from_column, from_row)];
      if (reached >= present) continue;
      present = reached;
      open.push({reached, Slot(from_column, from_row)});
    }
  }
}

double CostToGoField::At(double x, double y) const {
  const int column = static_cast<int>(std::floor((x - min_corner_.x()) / cell_ + 0.5));
  const int row = static_cast<int>(std::floor((y - min_corner_.y()) / cell_ + 0.5));
  return Inside(column, row) ? cost_[Slot(column, row)] : kInfinity;
}

bool CostToGoField::Inside(int column, int row) const {
  return column >= 0 && row >= 0 && column < columns_ && row < rows_;
}

std::size_t CostToGoField::Slot(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

}  // namespace dbd
