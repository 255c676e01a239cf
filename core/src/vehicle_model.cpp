#include <dbd/core/vehicle_model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dbd {

double VehicleModel::total_mass() const {
  double mass = 0;
  for (const BodyModel& body : bodies) mass += body.mass;
  return mass;
}

namespace {

/// Least and largest x of the axles.
std::pair<double, double> AxleRange(const VehicleModel& vehicle) {
  const auto [rear, front] =
      std::minmax_element(vehicle.axles.begin(), vehicle.axles.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  return {rear->x, front->x};
}

}  // namespace

double VehicleModel::wheelbase() const {
  const auto [rear, front] = AxleRange(*this);
  return front - rear;
}

double VehicleModel::middle_x() const {
  const auto [rear, front] = AxleRange(*this);
  return 0.5 * (rear + front);
}

double VehicleModel::path_point_x() const {
  double fixed = 0, all = 0;
  int count = 0;
  for (const AxleModel& axle : axles) {
    all += axle.x;
    if (axle.steer_ratio == 0) fixed += axle.x, ++count;
  }
  return count > 0 ? fixed / count : all / static_cast<double>(axles.size());
}

double VehicleModel::mean_track() const {
  double sum = 0;
  for (const AxleModel& axle : axles) sum += axle.track;
  return sum / static_cast<double>(axles.size());
}

double VehicleModel::min_turning_radius() const {
  // Each steered axle turns the vehicle about a centre beside the path point; the tightest circle
  // that all of them can follow counts.
  double radius = 0;
  for (const AxleModel& axle : axles) {
    if (axle.steer_ratio == 0) continue;
    radius = std::max(radius, std::abs(axle.x - path_point_x()) / std::tan(axle.max_steer));
  }
  constexpr double kControlReserve = 1.15;  // pure pursuit must be able to correct on a full turn
  return radius > 0 ? kControlReserve * radius : std::numeric_limits<double>::infinity();
}

double VehicleModel::mass_center_height() const {
  double moment = 0;
  for (const BodyModel& body : bodies) moment += body.mass * body.p_RB.z();
  return reference_height + moment / total_mass();
}

}  // namespace dbd
