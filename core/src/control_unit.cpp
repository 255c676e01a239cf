#include "control_unit.h"

namespace dbd {

ControlUnit::ControlUnit(const VehicleModel& vehicle) : vehicle_(&vehicle) {
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const auto axle = static_cast<std::size_t>(vehicle.wheels[i].axle);
    if (vehicle.axles[axle].driven) driven_.push_back(static_cast<int>(i));
  }
}

void ControlUnit::Update(const DriverCommand& command, const double* spins, double dt,
                         WheelControls<double>& controls) {
  double sum = 0;
  for (const int i : driven_) sum += spins[i];
  const double mean = driven_.empty() ? 0 : sum / static_cast<double>(driven_.size());
  const double torque =
      UpdatePowertrain(vehicle_->powertrain, command.engine_torque, mean, dt, powertrain_);
  AckermannSines(*vehicle_, command.steer, controls.steer_sine.data());
  for (const int i : driven_) {
    controls.drive_torque[static_cast<std::size_t>(i)] =
        torque / static_cast<double>(driven_.size());
  }
  for (std::size_t i = 0; i < vehicle_->wheels.size(); ++i) {
    controls.brake_torque[i] = command.brake * vehicle_->wheels[i].brake_torque;
  }
}

WheelControls<double> ControlUnit::HeldByBrakes() const {
  WheelControls<double> controls{};
  for (std::size_t i = 0; i < vehicle_->wheels.size(); ++i) {
    controls.brake_torque[i] = vehicle_->wheels[i].brake_torque;
  }
  return controls;
}

}  // namespace dbd
