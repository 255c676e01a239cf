#include <dbd/core/vehicle_model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {

double VehicleModel::total_mass() const {
  double mass = 0;
  for (const BodyModel& body : bodies) mass += body.mass;
  return mass;
}

double VehicleModel::wheelbase() const {
  const auto [rear, front] = std::minmax_element(
      axles.begin(), axles.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return front->x - rear->x;
}

double VehicleModel::mean_track() const {
  double sum = 0;
  for (const AxleModel& axle : axles) sum += axle.track;
  return sum / static_cast<double>(axles.size());
}

double VehicleModel::min_turning_radius() const {
  // Each steered axle turns the vehicle about a centre at its own distance from the fixed axles'
  // middle; the tightest that all of them can reach counts.
  double fixed_x = 0;
  int fixed = 0;
  for (const AxleModel& axle : axles) {
    if (axle.steer_ratio == 0) fixed_x += axle.x, ++fixed;
  }
  if (fixed > 0) fixed_x /= fixed;
  double radius = 0;
  for (const AxleModel& axle : axles) {
    if (axle.steer_ratio == 0) continue;
    radius = std::max(radius, std::abs(axle.x - fixed_x) / std::tan(axle.max_steer));
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
