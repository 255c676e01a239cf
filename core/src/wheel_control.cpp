#include "wheel_control.h"

namespace dbd {

WheelSpins SpinsOf(const EngineState<double>& state) {
  WheelSpins spins{};
  for (std::size_t i = 0; i < state.wheels.size(); ++i) spins[i] = state.wheels[i].spin;
  return spins;
}

void SetSteeringAndBrakes(const VehicleModel& vehicle, const DriverCommand& command,
                          WheelControls<double>& controls) {
  AckermannSines(vehicle, command.steer, controls.steer_sine.data());
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.brake_torque[i] = command.brake * vehicle.wheels[i].brake_torque;
  }
}

void SetDriveTorques(const VehicleModel& vehicle, const DriverCommand& command,
                     const WheelSpins& spins, double dt, PowertrainState& powertrain,
                     WheelControls<double>& controls) {
  const auto driven = [&](std::size_t i) {
    return vehicle.axles[static_cast<std::size_t>(vehicle.wheels[i].axle)].driven;
  };
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (!driven(i)) continue;
    sum += spins[i];
    ++count;
  }
  if (count == 0) return;
  SelectDirection(command.reverse, powertrain);
  const double torque =
      UpdatePowertrain(vehicle.powertrain, command.engine_torque, sum / count, dt, powertrain);
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.drive_torque[i] = driven(i) ? torque / count : 0;
  }
}

void SetControls(const VehicleModel& vehicle, const DriverCommand& command, const WheelSpins& spins,
                 double dt, PowertrainState& powertrain, WheelControls<double>& controls) {
  SetSteeringAndBrakes(vehicle, command, controls);
  SetDriveTorques(vehicle, command, spins, dt, powertrain, controls);
}

WheelControls<double> HeldByBrakes(const VehicleModel& vehicle) {
  WheelControls<double> controls{};
  SetSteeringAndBrakes(vehicle, {.brake = 1}, controls);
  return controls;
}

}  // namespace dbd
