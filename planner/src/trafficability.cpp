#include <dbd/planner/trafficability.h>

#include <dbd/core/error.h>
#include <dbd/core/internal/huge_pages.h>
#include <dbd/core/mobility.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "row_loop.h"
#include "trafficability_grid.h"

namespace dbd {
namespace {

// Where a vehicle file gives no tire, a step is judged as for a small one [m].
constexpr double kDefaultWheelRadius = 0.3;

double SmallestWheelRadius(const VehicleModel& vehicle) {
  double radius = std::numeric_limits<double>::infinity();
  for (const WheelModel& wheel : vehicle.wheels) radius = std::min(radius, wheel.tire.radius);
  return std::isfinite(radius) ? radius : kDefaultWheelRadius;
}

int HalfWindow(double half_footprint, double resolution) {
  return std::max(1, static_cast<int>(std::lround(half_footprint / resolution)));
}

}  // namespace

TrafficabilityLayer::TrafficabilityLayer(const Terrain& terrain, const VehicleModel& vehicle,
                                         double max_speed, const TrafficabilityOptions& options,
                                         const std::stop_token& stop)
    : terrain_(&terrain),
      options_(options),
      max_speed_(std::min(max_speed, vehicle.limits.max_speed)),
      half_wheelbase_(0.5 * vehicle.wheelbase()),
      half_track_(0.5 * vehicle.mean_track()),
      middle_ahead_(vehicle.middle_x() - vehicle.path_point_x()),
      box_center_ahead_(0.5 * (vehicle.outline.front - vehicle.outline.rear)),
      outline_(vehicle.outline) {
  if (!vehicle.bodies.empty()) {
    box_center_ahead_ += vehicle.bodies[0].p_RB.x() - vehicle.middle_x();
  }
  options.Validate();
  const double widened = 1.0 + options.tolerance;
  const VehicleLimits& limits = vehicle.limits;
  limits_ = {std::tan(limits.max_roll), std::tan(limits.max_pitch), std::tan(limits.max_slope)};
  tolerated_ = {std::tan(limits.max_roll * widened), std::tan(limits.max_pitch * widened),
                std::tan(limits.max_slope * widened)};
  crest_limit_ = outline_.belly_height > limits.min_clearance
                     ? (outline_.belly_height - limits.min_clearance) * widened
                     : std::numeric_limits<double>::infinity();
  for (const Material& material : terrain.materials().table().materials()) {
    footings_.push_back(FootingOn(vehicle, material));
  }
  const double half_footprint = std::max(half_wheelbase_, 0.5 * vehicle.mean_track());
  LayOutGrid(terrain.heights(), half_footprint);
  // Between two cells a face is a ramp one cell long: a wheel climbs about its radius, and the
  // ramp may add half of the largest slope.
  const double ramp = 0.5 * limits_.slope * resolution_;
  FillCells(half_footprint, (SmallestWheelRadius(vehicle) + ramp) * widened, stop);
  MarkNearObstacles(stop);
  MarkNearImpassable(stop);
}

void TrafficabilityLayer::LayOutGrid(const HeightMap& heights, double half_footprint) {
  const double finest = options_.min_resolution;
  const double cell = heights.grid().cell_size.maxCoeff();
  resolution_ = std::clamp(cell, finest, std::max(finest, half_footprint));
  min_corner_ = heights.min_corner();
  const Eigen::Vector2d extent = heights.max_corner() - min_corner_;
  const double cells = (extent.x() / resolution_ + 1) * (extent.y() / resolution_ + 1);
  if (cells > options_.max_cells) resolution_ *= 1.001 * std::sqrt(cells / options_.max_cells);
  // A hair more, so that rounding does not lose the last row.
  columns_ = static_cast<int>(extent.x() / resolution_ + 1e-6) + 1;
  rows_ = static_cast<int>(extent.y() / resolution_ + 1e-6) + 1;
}

void TrafficabilityLayer::FillCells(double half_footprint, double step_limit,
                                    const std::stop_token& stop) {
  const HeightGrid grid = SampleHeights(*terrain_, min_corner_, columns_, rows_, resolution_, stop);
  const int k = HalfWindow(half_footprint, resolution_);
  const std::vector<PlaneFit> fits = FitPlanes(grid, k, stop);
  const std::vector<std::uint8_t> steps = FindSteps(grid, step_limit);
  std::vector<std::uint8_t> unknown(grid.known.size());
  std::transform(grid.known.begin(), grid.known.end(), unknown.begin(),
                 [](std::uint8_t known) { return known ? std::uint8_t{0} : std::uint8_t{1}; });
  // A cell more than the footprint: tires stand out of it, and no driver keeps a path exactly.
  unknown = Dilate(unknown, columns_, rows_, k + 1, stop);
  // A crest of height c needs residuals whose squares add up to at least c^2 / 2.
  const double rugged = crest_limit_ / (std::sqrt(2.0) * (2 * k + 1));
  cells_ = std::make_shared<std::vector<Cell>>();
  cells_->reserve(fits.size());
  internal::AdviseHugePages(cells_->data(), fits.size() * sizeof(Cell));
  cells_->resize(fits.size());
  ForEachRow(0, rows_, stop, [&](int row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t i = grid.Index(column, row);
      Cell& cell = (*cells_)[i];
      cell.grade_x = fits[i].grade_x;
      cell.grade_y = fits[i].grade_y;
      cell.roughness = fits[i].roughness;
      cell.material = MaterialIndexAt(min_corner_.x() + column * resolution_,
                                      min_corner_.y() + row * resolution_);
      if (cell.roughness > rugged) cell.flags |= kRugged;
      const bool inside = column >= k && row >= k && column + k < columns_ && row + k < rows_;
      const bool has_material = cell.material != MaterialMap::kNone;
      cell.reason = !inside                       ? NoGoReason::kOutsideMap
                    : unknown[i] || !has_material ? NoGoReason::kUnknownGround
                                                  : footings_[cell.material].reason;
      if (cell.reason != NoGoReason::kNone) continue;
      if (steps[i]) cell.reason = NoGoReason::kStep;
      if (std::hypot(cell.grade_x, cell.grade_y) > tolerated_.slope) {
        cell.reason = NoGoReason::kSlope;
      }
    }
  });
}

TrafficabilityLayer::Footing TrafficabilityLayer::FootingOn(const VehicleModel& vehicle,
                                                            const Material& material) const {
  Footing footing;
  if (!material.passable) {
    footing.reason = NoGoReason::kImpassableMaterial;
    return footing;
  }
  footing.net_traction_ratio = MaxNetTractionRatio(vehicle, material.soil);
  footing.sinkage_share = StaticSinkage(vehicle, material.soil) / vehicle.limits.max_sinkage;
  if (footing.net_traction_ratio <= 0) footing.reason = NoGoReason::kTraction;
  if (footing.sinkage_share > 1 + options_.tolerance) footing.reason = NoGoReason::kSinkage;
  return footing;
}

std::uint8_t TrafficabilityLayer::MaterialIndexAt(double x, double y) const {
  const Material* material = terrain_->materials().At(x, y);
  if (material == nullptr) return MaterialMap::kNone;
  return static_cast<std::uint8_t>(material - terrain_->materials().table().materials().data());
}

void TrafficabilityLayer::MarkNearObstacles(const std::stop_token& stop) {
  for (const ObstacleLayer& layer : terrain_->obstacles().layers()) MarkNear(layer, stop);
}

void TrafficabilityLayer::MarkNear(const ObstacleLayer& obstacles, const std::stop_token& stop) {
  const HeightMap::Grid& grid = obstacles.grid();
  std::vector<std::uint8_t> marks(cells_->size(), 0);
  for (int row = 0; row < grid.rows; ++row) {
    ThrowIfStopped(stop);
    for (int column = 0; column < grid.columns; ++column) {
      const double x = grid.first_center.x() + column * grid.cell_size.x();
      const double y = grid.first_center.y() + row * grid.cell_size.y();
      if (!obstacles.BlocksBox({x, y}, 0, {0, 0}, outline_.height)) continue;
      const auto c = std::lround((x - min_corner_.x()) / resolution_);
      const auto r = std::lround((y - min_corner_.y()) / resolution_);
      if (c >= 0 && r >= 0 && c < columns_ && r < rows_) marks[r * columns_ + c] = 1;
    }
  }
  const double margin = options_.obstacle_margin;
  const double half_length = 0.5 * (outline_.front + outline_.rear);
  const double reach =
      std::hypot(std::abs(box_center_ahead_) + half_length + margin, outline_.half_width + margin) +
      0.5 * grid.cell_size.norm() + resolution_;
  FlagAround(std::move(marks), reach, kNearObstacle, stop);
}

void TrafficabilityLayer::MarkNearImpassable(const std::stop_token& stop) {
  std::vector<std::uint8_t> marks(cells_->size());
  std::transform(cells_->begin(), cells_->end(), marks.begin(), [](const Cell& cell) {
    return cell.reason == NoGoReason::kImpassableMaterial ? std::uint8_t{1} : std::uint8_t{0};
  });
  FlagAround(std::move(marks), std::hypot(half_wheelbase_, half_track_) + 2 * resolution_,
             kNearImpassable, stop);
}

void TrafficabilityLayer::FlagAround(std::vector<std::uint8_t> marks, double reach,
                                     std::uint8_t flag, const std::stop_token& stop) {
  marks = Dilate(marks, columns_, rows_, static_cast<int>(std::ceil(reach / resolution_)), stop);
  for (std::size_t i = 0; i < cells_->size(); ++i) {
    if (marks[i]) (*cells_)[i].flags |= flag;
  }
}

}  // namespace dbd
