#include "wheel_control.h"

namespace dbd {
namespace {

bool IsDriven(const VehicleModel& vehicle, const WheelModel& wheel) {
  return vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven;
}

}  // namespace

WheelSpins SpinsOf(const EngineState<double>& state) {
  WheelSpins spins{};
  for (std::size_t i = 0; i < state.wheels.size(); ++i) spins[i] = state.wheels[i].spin;
  return spins;
}

void SetSteeringAndBrakes(const VehicleModel& vehicle, const DriverCommand& command,
                          WheelControls<double>& controls) {
  SetSteeringAndBrakes(vehicle, AckermannGeometry(vehicle), command, controls);
}

void SetSteeringAndBrakes(const VehicleModel& vehicle, const AckermannGeometry& geometry,
                          const DriverCommand& command, WheelControls<double>& controls) {
  AckermannSines(vehicle, geometry, command.steer, controls.steer_sine.data());
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.brake_torque[i] = command.brake * vehicle.wheels[i].brake_torque;
  }
}

double DriveTorquePerWheel(const PowertrainModel& model, const DriverCommand& command, double spin,
                           int driven, double dt, PowertrainState& powertrain) {
  SelectDirection(command.reverse, powertrain);
  return UpdatePowertrain(model, command.engine_torque, spin, dt, powertrain) / driven;
}

void SetDriveTorques(const VehicleModel& vehicle, const DriverCommand& command,
                     const WheelSpins& spins, double dt, PowertrainState& powertrain,
                     WheelControls<double>& controls) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (!IsDriven(vehicle, vehicle.wheels[i])) continue;
    sum += spins[i];
    ++count;
  }
  if (count == 0) return;
  const double torque =
      DriveTorquePerWheel(vehicle.powertrain, command, sum / count, count, dt, powertrain);
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    controls.drive_torque[i] = IsDriven(vehicle, vehicle.wheels[i]) ? torque : 0;
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
