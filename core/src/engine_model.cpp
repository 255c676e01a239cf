#include "engine_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dbd {
namespace {

/// Wheels on one body share its inertia.
double CarrierInertia(const VehicleModel& model, int body) {
  int wheels = 0;
  for (const WheelModel& wheel : model.wheels) wheels += wheel.body == body;
  return model.bodies[body].inertia.y() / wheels;
}

}  // namespace

double CouplingTorque(const DifferentialModel& differential) {
  constexpr double kLockedTorque = 1e6;  // [N m] more than any axle carries
  switch (differential.type) {
    case DifferentialType::kOpen:
      return 0;
    case DifferentialType::kLimitedSlip:
      return differential.bias_torque;
    case DifferentialType::kLocked:
      return kLockedTorque;
  }
  return 0;
}

EngineModel::EngineModel(const VehicleModel& vehicle_model)
    : vehicle(&vehicle_model),
      joined(FindJoinedBodies(vehicle_model, [](const auto& p, const auto& q) { return p == q; })),
      centre_coupling(CouplingTorque(vehicle_model.powertrain.centre)),
      step(vehicle_model.steps.construction) {
  for (const WheelModel& wheel : vehicle->wheels) {
    patterns.push_back(MakeTirePattern(wheel.tire));
    tires.push_back(MakeTireNumbers(wheel.tire, step));
    carrier_inertia.push_back(CarrierInertia(vehicle_model, wheel.body));
  }
  for (const AxleModel& axle : vehicle->axles) {
    if (axle.driven) driven_wheels.insert(driven_wheels.end(), {axle.left, axle.right});
  }
  std::sort(driven_wheels.begin(), driven_wheels.end());
  for (const LinkModel& link : vehicle->links) torn_force.push_back(kTornLink * link.stiffness);
  for (const AxleModel& axle : vehicle->axles) {
    axle_coupling.push_back(CouplingTorque(axle.differential));
  }
  const auto every = [this](double group) { return static_cast<int>(std::lround(group / step)); };
  spring_every = every(vehicle->steps.spring);
  tire_every = every(vehicle->steps.tire);
  control_every = every(vehicle->steps.control);
  period = std::lcm(std::lcm(spring_every, tire_every), control_every);
}

EngineModel::~EngineModel() = default;

bool EngineModel::CouplesShafts() const {
  return centre_coupling > 0 || std::any_of(axle_coupling.begin(), axle_coupling.end(),
                                            [](double torque) { return torque > 0; });
}

std::int64_t EngineModel::SettlingSteps(double time) const {
  return period * static_cast<std::int64_t>(std::ceil(time / (period * step) - 1e-9));
}

}  // namespace dbd
