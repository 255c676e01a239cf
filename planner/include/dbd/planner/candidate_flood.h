#pragma once

#include <dbd/planner/trafficability.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dbd {

/// Which side of the question a flood answers.
enum class FloodDirection {
  kFrom,  ///< the cells that can be driven to from the origin
  kTo,    ///< the cells from which the origin can be driven to
};

/// Cells of the trafficability layer that connect to a place by moves to one of the eight
/// neighbours, each move judged with its own heading but without regard to turning. Tells whether
/// ground is enclosed, by what, and where a way through narrow places runs.
/// Throws StopRequested soon after `stop` was asked to.
class CellFlood {
 public:
  CellFlood(const TrafficabilityLayer& layer, const Eigen::Vector2d& origin,
            FloodDirection direction, std::stop_token stop = {});

  bool Reaches(const Eigen::Vector2d& place) const;
  std::size_t cell_count() const { return cell_count_; }

  /// Cell centres from the origin to a place that is reached, with the fewest moves.
  std::vector<Eigen::Vector2d> WayTo(const Eigen::Vector2d& place) const;

  /// What encloses the flooded cells on the side towards another place, which they do not reach:
  /// the reason that most parts them from the dry cells around it, cells counting 1 / (1 + d / 1
  /// m)^2 with their distance d from the straight line to it, and the cell with that reason nearest
  /// to the line.
  struct Barrier {
    NoGoReason reason = NoGoReason::kNone;
    Eigen::Vector2d where = Eigen::Vector2d::Zero();
  };
  Barrier BarrierTowards(const Eigen::Vector2d& other) const;

 private:
  struct CellIndex {
    int column = 0;
    int row = 0;
  };
  static constexpr std::uint8_t kDry = 255;
  static constexpr std::uint8_t kOrigin = 254;

  CellIndex IndexOf(const Eigen::Vector2d& place) const;
  CellIndex Neighbour(const CellIndex& cell, int move) const;
  Eigen::Vector2d Center(const CellIndex& cell) const;
  bool Inside(const CellIndex& cell) const;
  std::size_t Slot(const CellIndex& cell) const;
  NoGoReason JudgeMove(const CellIndex& to, int move) const;
  /// 1 for the dry cells that touch each other from this place on.
  std::vector<std::uint8_t> DryRegionOf(const Eigen::Vector2d& place) const;

  const TrafficabilityLayer& layer_;
  Eigen::Vector2d origin_;
  FloodDirection direction_;
  std::stop_token stop_;
  std::vector<std::uint8_t> reached_by_;  // the move that reached the cell, kOrigin or kDry
  std::size_t cell_count_ = 0;
};

}  // namespace dbd
