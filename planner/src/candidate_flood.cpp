#include <dbd/planner/candidate_flood.h>

#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace dbd {
namespace {

constexpr int kMoves = 8;
constexpr std::array<int, kMoves> kColumnStep{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, kMoves> kRowStep{0, 1, 1, 1, 0, -1, -1, -1};

double MoveHeading(int move) { return move * std::numbers::pi / 4; }

}  // namespace

CellFlood::CellFlood(const TrafficabilityLayer& layer, const Eigen::Vector2d& origin,
                     FloodDirection direction, std::stop_token stop)
    : layer_(layer),
      origin_(origin),
      direction_(direction),
      stop_(std::move(stop)),
      reached_by_(static_cast<std::size_t>(layer.columns()) * layer.rows(), kDry) {
  const CellIndex first = IndexOf(origin);
  if (!Inside(first)) return;
  reached_by_[Slot(first)] = kOrigin;
  std::vector<CellIndex> queue{first};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    ThrowIfStopped(stop_);
    const CellIndex cell = queue[next];
    for (int move = 0; move < kMoves; ++move) {
      const CellIndex to = Neighbour(cell, move);
      if (!Inside(to) || reached_by_[Slot(to)] != kDry) continue;
      if (JudgeMove(to, move) != NoGoReason::kNone) continue;
      reached_by_[Slot(to)] = static_cast<std::uint8_t>(move);
      queue.push_back(to);
    }
  }
  cell_count_ = queue.size();
}

bool CellFlood::Reaches(const Eigen::Vector2d& place) const {
  const CellIndex cell = IndexOf(place);
  return Inside(cell) && reached_by_[Slot(cell)] != kDry;
}

std::vector<Eigen::Vector2d> CellFlood::WayTo(const Eigen::Vector2d& place) const {
  std::vector<Eigen::Vector2d> way;
  if (!Reaches(place)) return way;
  CellIndex cell = IndexOf(place);
  for (std::uint8_t move = reached_by_[Slot(cell)];; move = reached_by_[Slot(cell)]) {
    way.push_back(Center(cell));
    if (move == kOrigin) break;
    cell = Neighbour(cell, (move + kMoves / 2) % kMoves);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<std::uint8_t> CellFlood::DryRegionOf(const Eigen::Vector2d& place) const {
  std::vector<std::uint8_t> region(reached_by_.size(), 0);
  const CellIndex first = IndexOf(place);
  if (!Inside(first)) return region;
  region[Slot(first)] = 1;
  std::vector<CellIndex> queue{first};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    ThrowIfStopped(stop_);
    for (int move = 0; move < kMoves; ++move) {
      const CellIndex to = Neighbour(queue[next], move);
      if (!Inside(to) || region[Slot(to)] || reached_by_[Slot(to)] != kDry) continue;
      region[Slot(to)] = 1;
      queue.push_back(to);
    }
  }
  return region;
}

CellFlood::Barrier CellFlood::BarrierTowards(const Eigen::Vector2d& other) const {
  const std::vector<std::uint8_t> beyond = DryRegionOf(other);
  const std::vector<Eigen::Vector2d> line{origin_, other};
  std::array<double, kNoGoReasonCount> weights{};
  std::array<double, kNoGoReasonCount> nearest;
  nearest.fill(std::numeric_limits<double>::infinity());
  std::array<Eigen::Vector2d, kNoGoReasonCount> places;
  places.fill(origin_);
  for (int row = 0; row < layer_.rows(); ++row) {
    ThrowIfStopped(stop_);
    for (int column = 0; column < layer_.columns(); ++column) {
      const CellIndex cell{column, row};
      if (reached_by_[Slot(cell)] == kDry) continue;
      for (int move = 0; move < kMoves; ++move) {
        const CellIndex to = Neighbour(cell, move);
        // A tree in the midst of flooded cells encloses nothing.
        if (Inside(to) && !beyond[Slot(to)]) continue;
        const auto reason = static_cast<std::size_t>(JudgeMove(to, move));
        const double distance = DistanceToPolyline(Center(to), line);
        weights[reason] += 1.0 / ((1.0 + distance) * (1.0 + distance));
        // Of places equally near to the line the first beyond the flooded cells.
        const double rank = distance + 1e-3 * (Center(to) - origin_).norm();
        if (rank < nearest[reason]) nearest[reason] = rank, places[reason] = Center(to);
      }
    }
  }
  const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return {static_cast<NoGoReason>(most), places[most]};
}

CellFlood::CellIndex CellFlood::IndexOf(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d cells = (place - layer_.min_corner()) / layer_.resolution();
  return {static_cast<int>(std::floor(cells.x() + 0.5)),
          static_cast<int>(std::floor(cells.y() + 0.5))};
}

CellFlood::CellIndex CellFlood::Neighbour(const CellIndex& cell, int move) const {
  return {cell.column + kColumnStep[move], cell.row + kRowStep[move]};
}

Eigen::Vector2d CellFlood::Center(const CellIndex& cell) const {
  return layer_.min_corner() + layer_.resolution() * Eigen::Vector2d(cell.column, cell.row);
}

bool CellFlood::Inside(const CellIndex& cell) const {
  return cell.column >= 0 && cell.row >= 0 && cell.column < layer_.columns() &&
         cell.row < layer_.rows();
}

std::size_t CellFlood::Slot(const CellIndex& cell) const {
  return static_cast<std::size_t>(cell.row) * layer_.columns() + cell.column;
}

NoGoReason CellFlood::JudgeMove(const CellIndex& to, int move) const {
  const int driven = direction_ == FloodDirection::kFrom ? move : (move + kMoves / 2) % kMoves;
  const Eigen::Vector2d place = Center(to);
  return layer_.Evaluate(place.x(), place.y(), MoveHeading(driven)).reason;
}

}  // namespace dbd
