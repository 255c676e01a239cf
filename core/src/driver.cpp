#include <dbd/core/driver.h>
#include <dbd/core/powertrain.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

constexpr double kCurvatureWindow = 1.5;  // [m] to each side
constexpr double kFarAhead = 1e4;         // [m] length of the line driven when there is no path
constexpr double kStandstill = 0.05;      // [m/s]
constexpr double kAtEnd = 0.1;            // [m] from the end of a stretch, to stop there

/// A braked vehicle rocks on its springs: it has come to a stop when its speed passes zero, which
/// no decision may see.
bool Stands(const DriverView& view, const DriverState& state) {
  return std::abs(view.speed) < kStandstill || view.speed * state.last_speed < 0;
}

/// The steered axle farthest from the fixed line: the mean steer angle is its angle.
const AxleModel& LeadingAxle(const VehicleModel& vehicle) {
  const double x0 = vehicle.path_point_x();
  const AxleModel* lead = nullptr;
  for (const AxleModel& axle : vehicle.axles) {
    if (axle.steer_ratio == 0) continue;
    if (lead == nullptr || std::abs(axle.x - x0) > std::abs(lead->x - x0)) lead = &axle;
  }
  return *lead;
}

}  // namespace

AckermannGeometry::AckermannGeometry(const VehicleModel& vehicle)
    : path_point_x(vehicle.path_point_x()), wheelbase(LeadingAxle(vehicle).x - path_point_x) {}

void AckermannSines(const VehicleModel& vehicle, const AckermannGeometry& geometry, double steer,
                    double* sines) {
  const double x0 = geometry.path_point_x;
  const double curvature = std::tan(steer) / geometry.wheelbase;
  for (const AxleModel& axle : vehicle.axles) {
    for (const bool left : {true, false}) {
      const int wheel = left ? axle.left : axle.right;
      sines[wheel] = 0;
      if (axle.steer_ratio == 0) continue;
      const double side = (left ? 0.5 : -0.5) * axle.track;
      const double tangent = (axle.x - x0) * curvature / (1 - side * curvature);
      sines[wheel] = tangent / std::sqrt(1 + tangent * tangent);
    }
  }
}

std::vector<double> AckermannAngles(const VehicleModel& vehicle, double steer) {
  std::vector<double> angles(vehicle.wheels.size());
  AckermannSines(vehicle, AckermannGeometry(vehicle), steer, angles.data());
  for (double& angle : angles) angle = std::asin(angle);
  return angles;
}

Driver::Driver(const VehicleModel& vehicle, const Path& path, const DriverOptions& options)
    : vehicle_(vehicle), path_(path), options_(options) {
  const AxleModel& lead = LeadingAxle(vehicle);
  wheelbase_ = lead.x - vehicle.path_point_x();
  max_steer_ = lead.max_steer;
  torque_per_acceleration_ = vehicle.total_mass() / TractionPerEngineTorque(vehicle);
  options_.target_speed = std::min(options_.target_speed, vehicle.limits.max_speed);
  options_.curve_acceleration =
      std::min(options_.curve_acceleration, vehicle.limits.max_lateral_acceleration);
  if (!path_.empty()) BuildSpeedProfile();
}

void Driver::SetStart(const Eigen::Vector2d& position, double heading) {
  if (!path_.empty()) return;
  const Eigen::Vector2d ahead(std::cos(heading), std::sin(heading));
  path_ = Path({position, position + kFarAhead * ahead});
  options_.stop_at_end = false;
}

/// Curves and the ground limit the speed; a backward sweep makes the vehicle brake before them.
void Driver::BuildSpeedProfile() {
  const int count = static_cast<int>(std::ceil(path_.length() / kSpeedLimitSpacing)) + 1;
  speed_profile_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double curvature = std::abs(path_.Curvature(i * kSpeedLimitSpacing, kCurvatureWindow));
    const double curve = std::sqrt(options_.curve_acceleration / std::max(curvature, 1e-6));
    speed_profile_[static_cast<std::size_t>(i)] = std::min(options_.target_speed, curve);
  }
  for (const PathStretch& stretch : path_.stretches()) {
    if (!stretch.reverse) continue;
    for (int i = static_cast<int>(stretch.begin / kSpeedLimitSpacing);
         i < count && i * kSpeedLimitSpacing < stretch.end; ++i) {
      double& limit = speed_profile_[static_cast<std::size_t>(i)];
      limit = std::min(limit, kReverseSpeed);
    }
  }
  const std::size_t given = std::min(options_.speed_limits.size(), speed_profile_.size());
  for (std::size_t i = 0; i < given; ++i) {
    speed_profile_[i] = std::min(speed_profile_[i], options_.speed_limits[i]);
  }
  for (std::size_t i = speed_profile_.size() - 1; i-- > 0;) {
    const double next = speed_profile_[i + 1];
    const double reachable =
        std::sqrt(next * next + 2 * options_.deceleration * kSpeedLimitSpacing);
    speed_profile_[i] = std::min(speed_profile_[i], reachable);
  }
}

double Driver::SpeedLimit(double s) const {
  if (speed_profile_.empty()) return options_.target_speed;
  const auto last = static_cast<double>(speed_profile_.size() - 1);
  const double index = std::clamp(s / kSpeedLimitSpacing, 0.0, last);
  return speed_profile_[static_cast<std::size_t>(index)];
}

const PathStretch& Driver::Stretch(const DriverState& state) const {
  return path_.stretches()[state.stretch];
}

bool Driver::OnLastStretch(const DriverState& state) const {
  return state.stretch + 1 == path_.stretches().size();
}

double Driver::SpeedAlongPath(const DriverView& view, const DriverState& state) const {
  return Stretch(state).reverse ? -view.speed : view.speed;
}

/// Standing at the end of a stretch, goes on with the next.
void Driver::ChangeDirection(DriverState& state) const {
  if (OnLastStretch(state) || state.target_speed > 0) return;
  if (Stretch(state).end - state.arc_length > kAtEnd) return;
  ++state.stretch;
  state.arc_length = Stretch(state).begin;
}

double Driver::TargetSpeed(const DriverView& view, double dt, DriverState& state) const {
  const PathStretch& stretch = Stretch(state);
  const double ahead = std::min(state.arc_length + 0.3 * SpeedAlongPath(view, state), stretch.end);
  const double allowed = std::min(SpeedLimit(ahead), view.speed_limit);
  GoingView going = view.going;
  if (stretch.reverse) going.climb = -going.climb;
  const double limit = CarefulSpeed(options_.care, vehicle_.limits, going, allowed, dt, state.care);
  if (OnLastStretch(state) && !options_.stop_at_end) return limit;
  const double left = stretch.end - state.arc_length;
  return left <= kAtEnd ? 0.0 : std::min(limit, std::sqrt(2 * options_.deceleration * left));
}

/// Pure pursuit: the arc through the lookahead point, curvature 2 y / d^2. In reverse that point
/// lies behind, and the same arc leads there.
double Driver::Steer(const DriverView& view, DriverState& state) const {
  const PathStretch& stretch = Stretch(state);
  const double speed = SpeedAlongPath(view, state);
  const double window = 2.0 + 2 * std::abs(speed);
  state.arc_length = path_.NearestArcLength(view.position, state.arc_length,
                                            std::min(state.arc_length + window, stretch.end));
  const double lookahead =
      options_.least_lookahead + options_.lookahead_time * std::max(0.0, speed);
  const Eigen::Vector2d d = path_.PositionOn(stretch, state.arc_length + lookahead) - view.position;
  const double lateral = -std::sin(view.heading) * d.x() + std::cos(view.heading) * d.y();
  const double curvature = 2 * lateral / std::max(d.squaredNorm(), 1e-3);
  return std::clamp(std::atan(curvature * wheelbase_), -max_steer_, max_steer_);
}

DriverCommand Driver::Update(const DriverView& view, double dt, DriverState& state) const {
  DriverCommand command;
  const bool stands = Stands(view, state);
  state.last_speed = view.speed;
  if (stands) ChangeDirection(state);
  command.steer = Steer(view, state);
  command.reverse = Stretch(state).reverse;
  state.target_speed = TargetSpeed(view, dt, state);
  const double error = state.target_speed - SpeedAlongPath(view, state);
  const double gain = options_.speed_gain * torque_per_acceleration_;
  const double integral_gain = options_.integral_gain * torque_per_acceleration_;
  state.integral = std::clamp(state.integral + integral_gain * error * dt, -10 * gain, 10 * gain);
  if (state.target_speed <= 0) {
    state.integral = 0;
    command.brake = 1;
    state.arrived = OnLastStretch(state) && stands;
    return command;
  }
  command.engine_torque = gain * error + state.integral;
  if (error < -0.5) {
    command.brake = std::min(1.0, options_.brake_gain * (-error - 0.5));
    state.integral = std::min(state.integral, 0.0);
  }
  return command;
}

}  // namespace dbd
