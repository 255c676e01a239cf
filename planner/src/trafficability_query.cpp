#include <dbd/core/error.h>
#include <dbd/planner/trafficability.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dbd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Shape of the cost, see SecondsPerMetre in the header.
constexpr double kSlowdown = 0.8;
constexpr double kRiskPole = 1.15;
constexpr double kLargestRisk = 100.0;
constexpr double kUsedBesideObstacle = 0.6;
// Drivers keep to a path within some decimetres: with less room than this, luck decides.
constexpr double kElbowRoom = 0.5;  // [m] on top of the obstacle margin
constexpr double kUsedWithoutElbowRoom = 0.9;

void Check(bool holds, const char* field, double value, const char* rule) {
  if (holds) return;
  throw InputError("trafficability." + std::string(field) + ": " + std::to_string(value) +
                   " must be " + rule);
}

}  // namespace

const char* NoGoReasonName(NoGoReason reason) {
  static constexpr const char* kNames[kNoGoReasonCount] = {
      "none",    "outside-map", "unknown-ground", "impassable-material",
      "sinkage", "obstacle",    "step",           "slope",
      "pitch",   "roll",        "clearance",      "traction"};
  return kNames[static_cast<int>(reason)];
}

const char* NoGoReasonText(NoGoReason reason) {
  static constexpr const char* kTexts[kNoGoReasonCount] = {
      "nothing speaks against it",
      "the vehicle would leave the map",
      "the ground was not surveyed",
      "the material is impassable",
      "the wheels would sink in too deep",
      "an obstacle is in the way",
      "there is a step that the wheels cannot climb",
      "the ground is steeper than the slope limit",
      "the grade is above the pitch limit",
      "the side slope is above the roll limit",
      "the belly would touch the ground",
      "the net traction is too small for the grade"};
  return kTexts[static_cast<int>(reason)];
}

void TrafficabilityOptions::Validate() const {
  Check(min_resolution > 0, "min_resolution", min_resolution, "positive");
  Check(max_cells >= 1000, "max_cells", max_cells, "at least 1000");
  Check(tolerance >= 0 && tolerance <= 0.5, "tolerance", tolerance, "in [0, 0.5]");
  Check(obstacle_margin >= 0, "obstacle_margin", obstacle_margin, "zero or more");
  Check(climb_cost >= 0, "climb_cost", climb_cost, "zero or more");
  Check(risk_cost >= 0, "risk_cost", risk_cost, "zero or more");
  Check(roughness_scale > 0, "roughness_scale", roughness_scale, "positive");
}

Eigen::Vector2d TrafficabilityLayer::max_corner() const {
  return min_corner_ + resolution_ * Eigen::Vector2d(columns_ - 1, rows_ - 1);
}

TrafficabilityLayer TrafficabilityLayer::WithExtraCost(
    std::shared_ptr<const ExtraCost> extra) const {
  TrafficabilityLayer layer = *this;
  layer.extra_ = std::move(extra);
  return layer;
}

TrafficabilityLayer TrafficabilityLayer::WithFlatCost() const {
  TrafficabilityLayer layer = *this;
  layer.flat_ = true;
  return layer;
}

const TrafficabilityLayer::Cell* TrafficabilityLayer::CellAt(double x, double y) const {
  // Written so that coordinates that are not numbers fail.
  const double column = (x - min_corner_.x()) / resolution_ + 0.5;
  const double row = (y - min_corner_.y()) / resolution_ + 0.5;
  if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return nullptr;
  return cells_->data() + static_cast<std::size_t>(row) * columns_ +
         static_cast<std::size_t>(column);
}

CellVerdict TrafficabilityLayer::EvaluateAnyHeading(double x, double y) const {
  const Cell* cell = CellAt(x, y);
  return {cell == nullptr ? NoGoReason::kOutsideMap : cell->reason};
}

CellVerdict TrafficabilityLayer::Evaluate(double x, double y, double heading) const {
  return Evaluate(DirectedPose({x, y, heading}));
}

CellVerdict TrafficabilityLayer::Evaluate(const DirectedPose& pose) const {
  const double x = pose.x + middle_ahead_ * pose.cos_h;
  const double y = pose.y + middle_ahead_ * pose.sin_h;
  const Cell* cell = CellAt(x, y);
  if (cell == nullptr) return {NoGoReason::kOutsideMap};
  return {Judge(*cell, x, y, pose.cos_h, pose.sin_h)};
}

NoGoReason TrafficabilityLayer::Judge(const Cell& cell, double x, double y, double cos_h,
                                      double sin_h) const {
  if (cell.reason != NoGoReason::kNone) return cell.reason;
  const double grade = cell.grade_x * cos_h + cell.grade_y * sin_h;
  const double side_slope = cell.grade_y * cos_h - cell.grade_x * sin_h;
  if (std::abs(grade) > tolerated_.pitch) return NoGoReason::kPitch;
  if (std::abs(side_slope) > tolerated_.roll) return NoGoReason::kRoll;
  const double climbable = footings_[cell.material].net_traction_ratio * (1 + options_.tolerance);
  if (grade > climbable) return NoGoReason::kTraction;
  if ((cell.flags & kRugged) && BellyTouches(x, y, cos_h, sin_h)) return NoGoReason::kClearance;
  if ((cell.flags & kNearObstacle) && HitsObstacle(x, y, cos_h, sin_h, options_.obstacle_margin)) {
    return NoGoReason::kObstacle;
  }
  if ((cell.flags & kNearImpassable) && WheelIsOnImpassable(x, y, cos_h, sin_h)) {
    return NoGoReason::kImpassableMaterial;
  }
  return NoGoReason::kNone;
}

/// Looks at the tracks' outer edges, before, beside and behind the vehicle's middle.
bool TrafficabilityLayer::WheelIsOnImpassable(double x, double y, double cos_h,
                                              double sin_h) const {
  const double across = half_track_ + options_.obstacle_margin;
  for (const double along : {-half_wheelbase_, 0.0, half_wheelbase_}) {
    for (const double side : {-across, across}) {
      const Cell* cell = CellAt(x + along * cos_h - side * sin_h, y + along * sin_h + side * cos_h);
      if (cell != nullptr && cell->reason == NoGoReason::kImpassableMaterial) return true;
    }
  }
  return false;
}

bool TrafficabilityLayer::BellyTouches(double x, double y, double cos_h, double sin_h) const {
  const double dx = half_wheelbase_ * cos_h;
  const double dy = half_wheelbase_ * sin_h;
  const double xs[3] = {x - dx, x, x + dx};
  const double ys[3] = {y - dy, y, y + dy};
  double z[3];
  terrain_->Heights(3, xs, ys, z);
  return z[1] - 0.5 * (z[0] + z[2]) > crest_limit_;
}

bool TrafficabilityLayer::HitsObstacle(double x, double y, double cos_h, double sin_h,
                                       double margin) const {
  const Eigen::Vector2d center(x + box_center_ahead_ * cos_h, y + box_center_ahead_ * sin_h);
  const Eigen::Vector2d half_extents(0.5 * (outline_.front + outline_.rear) + margin,
                                     outline_.half_width + margin);
  return terrain_->obstacles().BlocksBox(center, std::atan2(sin_h, cos_h), half_extents,
                                         outline_.height);
}

double TrafficabilityLayer::UsedShare(const Cell& cell, double grade, double side_slope) const {
  const Footing& footing = footings_[cell.material];
  double used = std::max(std::abs(grade) / limits_.pitch, std::abs(side_slope) / limits_.roll);
  used = std::max(used, grade / footing.net_traction_ratio);
  used = std::max(used, footing.sinkage_share);
  // A hypotenuse to the last bit takes long, and is mostly not what uses most.
  const double enough = used * limits_.slope;
  const double squared = grade * grade + side_slope * side_slope;
  if (squared < (1 - 1e-12) * enough * enough) return used;
  return std::max(used, std::hypot(grade, side_slope) / limits_.slope);
}

double TrafficabilityLayer::UsedBesideObstacles(double x, double y, double cos_h,
                                                double sin_h) const {
  const double room = options_.obstacle_margin + kElbowRoom;
  return HitsObstacle(x, y, cos_h, sin_h, room) ? kUsedWithoutElbowRoom : kUsedBesideObstacle;
}

void TrafficabilityLayer::Prefetch(const DirectedPose& pose) const {
  const Cell* cell =
      CellAt(pose.x + middle_ahead_ * pose.cos_h, pose.y + middle_ahead_ * pose.sin_h);
  if (cell != nullptr) __builtin_prefetch(cell);
}

double TrafficabilityLayer::SecondsPerMetre(double x, double y, double heading) const {
  return SecondsPerMetre(DirectedPose({x, y, heading}));
}

double TrafficabilityLayer::SecondsPerMetre(const DirectedPose& pose) const {
  const double cos_h = pose.cos_h, sin_h = pose.sin_h;
  const double x = pose.x + middle_ahead_ * cos_h;
  const double y = pose.y + middle_ahead_ * sin_h;
  const Cell* cell = CellAt(x, y);
  if (cell == nullptr || cell->reason != NoGoReason::kNone) return kInfinity;
  if (Judge(*cell, x, y, cos_h, sin_h) != NoGoReason::kNone) return kInfinity;
  if (flat_) return min_seconds_per_metre();
  const double grade = cell->grade_x * cos_h + cell->grade_y * sin_h;
  const double side_slope = cell->grade_y * cos_h - cell->grade_x * sin_h;
  double used = UsedShare(*cell, grade, side_slope);
  if (cell->flags & kNearObstacle) used = std::max(used, UsedBesideObstacles(x, y, cos_h, sin_h));
  const double open = std::max(0.1, 1.0 - kSlowdown * used);
  const double speed = max_speed_ * open / (1.0 + cell->roughness / options_.roughness_scale);
  const double margin_left = std::max(1e-3, kRiskPole - used);
  const double risk = std::min(kLargestRisk, std::pow(used / margin_left, 2));
  const double extra = extra_ ? extra_->SecondsPerMetre(x, y) : 0.0;
  return 1.0 / speed + options_.climb_cost * std::max(0.0, grade) + options_.risk_cost * risk +
         extra;
}

}  // namespace dbd
