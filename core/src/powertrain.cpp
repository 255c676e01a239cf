#include <dbd/core/powertrain.h>
#include <dbd/core/terramechanics.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

double TotalRatio(const PowertrainModel& powertrain, int gear) {
  return powertrain.gear_ratios[static_cast<std::size_t>(gear)] * powertrain.transfer_ratio *
         powertrain.final_ratio;
}

double RatioInUse(const PowertrainModel& powertrain, const PowertrainState& state) {
  if (!state.reverse) return TotalRatio(powertrain, state.gear);
  return -powertrain.reverse_ratio * powertrain.transfer_ratio * powertrain.final_ratio;
}

/// Gear 0 is the lowest: ratios fall. Shifts are `shift_interval` apart, so that the choice does
/// not hunt.
void ChooseGear(const PowertrainModel& powertrain, double wheel_speed, PowertrainState& state) {
  if (state.reverse || state.time_in_gear < powertrain.shift_interval) return;
  const double speed = wheel_speed * TotalRatio(powertrain, state.gear);
  const int last = static_cast<int>(powertrain.gear_ratios.size()) - 1;
  const int wish = speed > powertrain.upshift_speed     ? state.gear + 1
                   : speed < powertrain.downshift_speed ? state.gear - 1
                                                        : state.gear;
  const int gear = std::clamp(wish, 0, last);
  if (gear == state.gear) return;
  state.gear = gear;
  state.time_in_gear = 0;
}

/// Share of the torque that the clutch passes since the last shift.
double Engagement(const PowertrainModel& powertrain, double time_in_gear) {
  constexpr double kClosed = 18;  // time constants: the exponential is below a float's round-off
  if (time_in_gear >= kClosed * powertrain.clutch_time) return 1;
  return 1 - std::exp(-time_in_gear / powertrain.clutch_time);
}

double DrivenRadius(const VehicleModel& vehicle) {
  double radius = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    if (!vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven) continue;
    radius = LoadedRollingRadius(wheel.tire.radius, wheel.static_load / wheel.tire.stiffness);
  }
  return radius;
}

}  // namespace

double FullThrottleTorque(const PowertrainModel& powertrain, double engine_speed) {
  if (engine_speed > powertrain.max_speed) return 0;
  const double w = std::max(engine_speed, powertrain.min_speed);
  const auto& [a, b, c] = powertrain.torque_polynomial;
  return std::max(0.0, (a * w + b) * w + c);
}

void SelectDirection(bool reverse, PowertrainState& state) {
  if (state.reverse == reverse) return;
  state.reverse = reverse;
  state.gear = 0;
  state.time_in_gear = 0;
}

double UpdatePowertrain(const PowertrainModel& powertrain, double asked_torque, double wheel_speed,
                        double dt, PowertrainState& state) {
  ChooseGear(powertrain, wheel_speed, state);
  state.time_in_gear += dt;
  const double ratio = RatioInUse(powertrain, state);  // negative in reverse
  const double shaft_speed = wheel_speed * ratio;
  state.engine_speed = std::clamp(shaft_speed, powertrain.min_speed, powertrain.max_speed);
  // A slipping clutch passes drive but no engine braking, which would turn the wheels backwards.
  const double least = shaft_speed > powertrain.min_speed ? -powertrain.braking_torque : 0.0;
  const double most = FullThrottleTorque(powertrain, shaft_speed);
  state.engine_torque = Engagement(powertrain, state.time_in_gear) *
                        std::clamp(asked_torque, least, std::max(most, least));
  return state.engine_torque * ratio * powertrain.efficiency;
}

double TopSpeed(const VehicleModel& vehicle) {
  const PowertrainModel& powertrain = vehicle.powertrain;
  const int last = static_cast<int>(powertrain.gear_ratios.size()) - 1;
  return powertrain.max_speed / TotalRatio(powertrain, last) * DrivenRadius(vehicle);
}

double TractionPerEngineTorque(const VehicleModel& vehicle) {
  const PowertrainModel& powertrain = vehicle.powertrain;
  return TotalRatio(powertrain, 0) * powertrain.efficiency / DrivenRadius(vehicle);
}

double MaxWheelTorque(const PowertrainModel& powertrain) {
  double most = 0;
  for (int i = 0; i <= 100; ++i) {
    const double w =
        powertrain.min_speed + 0.01 * i * (powertrain.max_speed - powertrain.min_speed);
    most = std::max(most, FullThrottleTorque(powertrain, w));
  }
  return most * TotalRatio(powertrain, 0) * powertrain.efficiency;
}

}  // namespace dbd
