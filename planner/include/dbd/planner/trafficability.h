#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/dubins.h>
#include <dbd/planner/extra_cost.h>
#include <dbd/planner/stop.h>
#include <dbd/terrain/terrain.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace dbd {

/// Why a vehicle cannot stand or drive at a place.
enum class NoGoReason : std::uint8_t {
  kNone,
  kOutsideMap,  ///< the footprint leaves the map
  kUnknownGround,
  kImpassableMaterial,
  kSinkage,
  kObstacle,
  kStep,
  kSlope,
  kPitch,
  kRoll,
  kClearance,
  kTraction,
};
inline constexpr int kNoGoReasonCount = 12;

/// One word, as used in files: "roll", "unknown-ground", ...
const char* NoGoReasonName(NoGoReason reason);

/// What is the matter, to be put after "because": "the side slope is above the roll limit".
const char* NoGoReasonText(NoGoReason reason);

struct CellVerdict {
  NoGoReason reason = NoGoReason::kNone;
  bool go() const { return reason == NoGoReason::kNone; }
};

struct TrafficabilityOptions {
  double min_resolution = 0.5;    ///< finest cell [m]
  int max_cells = 4'000'000;      ///< larger maps get coarser cells
  double tolerance = 0.1;         ///< share by which a limit may be passed before no-go
  double obstacle_margin = 0.2;   ///< free space beside and before the vehicle [m]
  double climb_cost = 1.0;        ///< seconds that one metre of climb is worth [s/m]
  double risk_cost = 0.15;        ///< weight of the risk term, see SecondsPerMetre [s/m]
  double roughness_scale = 0.08;  ///< rms roughness that halves the speed [m]

  /// Throws InputError that names the field, its value and the rule.
  void Validate() const;
};

/// The cheap judge: where and in which direction may the vehicle drive, and how fast about.
///
/// A grid over the terrain holds, per cell, the ground's gradient (least squares over a square of
/// the vehicle's footprint), the roughness about that plane and what speaks against the cell
/// whatever the heading. Cells are as large as those of the elevation, at least `min_resolution`
/// and at most half a wheelbase; when `max_cells` is not enough they grow.
///
/// Limits come from `VehicleModel::limits`, widened by `tolerance`: the layer never decides that
/// a route is safe, full dynamics does, so it must not refuse what could be driven. The cost grows
/// steeply as limits are approached, which keeps routes off the edge all the same.
///
/// Obstacles are looked up with the oriented box of the vehicle at the time of the query, but only
/// in cells that have one within the box's circumcircle: a grid inflated by half the width would
/// either close gaps that the vehicle fits through or forget its corners.
///
/// Immutable after construction, safe for many threads. Keeps a reference to the terrain. The
/// constructor throws StopRequested soon after `stop` was asked to.
class TrafficabilityLayer {
 public:
  TrafficabilityLayer(const Terrain& terrain, const VehicleModel& vehicle, double max_speed,
                      const TrafficabilityOptions& options = {}, const std::stop_token& stop = {});

  /// Go or no-go with the vehicle's path point (`VehicleModel::path_point_x`) at x, y [m, W] and a
  /// heading [rad]. What is looked at is the ground under the vehicle's middle, which lies ahead.
  CellVerdict Evaluate(double x, double y, double heading) const;
  CellVerdict Evaluate(const DirectedPose& pose) const;

  /// What speaks against the place whatever the heading; obstacles are not looked up.
  CellVerdict EvaluateAnyHeading(double x, double y) const;

  /// Cost of travel there [s/m]: 1 / expected speed + climb + risk + what `WithExtraCost` says;
  /// infinite where no-go.
  ///
  /// With u the largest used share of a limit (roll, pitch, slope, traction, sinkage), the speed
  /// is max_speed (1 - 0.8 u) / (1 + roughness / roughness_scale), and the risk is
  /// risk_cost (u / (1.15 - u))^2, at most 100 risk_cost. Beside an obstacle u is at least 0.6, and
  /// 0.9 with less than 0.5 m of room on top of the margin.
  double SecondsPerMetre(double x, double y, double heading) const;
  double SecondsPerMetre(const DirectedPose& pose) const;

  /// Asks the processor for what the next question about this pose needs, so that it is there when
  /// other work in between is done.
  void Prefetch(const DirectedPose& pose) const;

  /// The same layer with another cost on top; it shares the cells.
  TrafficabilityLayer WithExtraCost(std::shared_ptr<const ExtraCost> extra) const;

  /// The same layer where all that is go costs the same: the least cost is the least length.
  TrafficabilityLayer WithFlatCost() const;

  /// No place costs less [s/m].
  double min_seconds_per_metre() const { return 1.0 / max_speed_; }

  double resolution() const { return resolution_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const Eigen::Vector2d& min_corner() const { return min_corner_; }
  Eigen::Vector2d max_corner() const;
  std::size_t memory_bytes() const { return cells_->size() * sizeof(Cell); }

 private:
  struct Cell {
    float grade_x = 0;  // of the fitted plane [-]
    float grade_y = 0;
    float roughness = 0;                    // rms about the plane [m]
    NoGoReason reason = NoGoReason::kNone;  // whatever the heading
    std::uint8_t material = 0;
    std::uint8_t flags = 0;
  };
  static constexpr std::uint8_t kNearObstacle = 1;
  static constexpr std::uint8_t kRugged = 2;          // the belly could touch: look at the heights
  static constexpr std::uint8_t kNearImpassable = 4;  // look where the wheels stand

  // What a material means to the vehicle.
  struct Footing {
    NoGoReason reason = NoGoReason::kNone;
    double net_traction_ratio = 0;
    double sinkage_share = 0;  // of the limit
  };

  // Tangents of the largest angles.
  struct Bounds {
    double roll = 0;
    double pitch = 0;
    double slope = 0;
  };

  void LayOutGrid(const HeightMap& heights, double half_footprint);
  void FillCells(double half_footprint, double step_limit, const std::stop_token& stop);
  void MarkNearObstacles(const std::stop_token& stop);
  void MarkNear(const ObstacleLayer& obstacles, const std::stop_token& stop);
  void MarkNearImpassable(const std::stop_token& stop);
  /// Dilates `marks` by `reach` [m] and sets `flag` in the cells that are marked then.
  void FlagAround(std::vector<std::uint8_t> marks, double reach, std::uint8_t flag,
                  const std::stop_token& stop);
  Footing FootingOn(const VehicleModel& vehicle, const Material& material) const;
  std::uint8_t MaterialIndexAt(double x, double y) const;

  const Cell* CellAt(double x, double y) const;
  NoGoReason Judge(const Cell& cell, double x, double y, double cos_h, double sin_h) const;
  double UsedShare(const Cell& cell, double grade, double side_slope) const;
  bool BellyTouches(double x, double y, double cos_h, double sin_h) const;
  bool HitsObstacle(double x, double y, double cos_h, double sin_h, double margin) const;
  double UsedBesideObstacles(double x, double y, double cos_h, double sin_h) const;
  bool WheelIsOnImpassable(double x, double y, double cos_h, double sin_h) const;

  const Terrain* terrain_;
  TrafficabilityOptions options_;
  double max_speed_;
  double half_wheelbase_;
  double half_track_;
  double middle_ahead_;      // of the path point
  double box_center_ahead_;  // of the vehicle's middle
  double crest_limit_;
  VehicleOutline outline_;
  Bounds limits_;
  Bounds tolerated_;
  double resolution_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  Eigen::Vector2d min_corner_;
  std::shared_ptr<std::vector<Cell>> cells_;  // not changed after construction
  std::shared_ptr<const ExtraCost> extra_;    // null: none
  bool flat_ = false;
  std::vector<Footing> footings_;
};

}  // namespace dbd
