#include <dbd/core/error.h>
#include <dbd/core/vehicle_variant.h>

#include <cmath>

#include "time_steps.h"
#include "trim.h"

namespace dbd {
namespace {

constexpr double kReferenceFrontTire = 207e3;  // [N/m]
constexpr double kReferenceRearTire = 235e3;

void TrimAgain(VehicleModel& vehicle) {
  for (SpringModel& spring : vehicle.springs) spring.free_length = 0;
  TrimWheelLoads(vehicle.name, vehicle);
  TrimFreeLengths(vehicle);
  vehicle.steps = ChooseStepSizes(vehicle);
}

}  // namespace

VehicleModel WithLinkStiffness(VehicleModel vehicle, double factor) {
  if (!(factor > 0)) throw InputError("link stiffness factor must be greater than 0");
  const double root = std::sqrt(factor);
  for (LinkModel& link : vehicle.links) link.stiffness *= factor, link.damping *= root;
  for (AxisJointModel& joint : vehicle.joints) joint.stiffness *= factor, joint.damping *= root;
  TrimAgain(vehicle);
  return vehicle;
}

VehicleModel WithTireStiffness(VehicleModel vehicle, const std::vector<double>& stiffness) {
  if (stiffness.size() != vehicle.axles.size()) {
    throw InputError("tire stiffness: needs one number for each of " +
                     std::to_string(vehicle.axles.size()) + " axles");
  }
  for (WheelModel& wheel : vehicle.wheels) {
    const double k = stiffness[static_cast<std::size_t>(wheel.axle)];
    if (!(k > 0)) throw InputError("tire stiffness must be greater than 0");
    wheel.tire.stiffness = k;
  }
  TrimAgain(vehicle);
  return vehicle;
}

VehicleModel WithReferenceTires(const VehicleModel& vehicle) {
  std::vector<double> stiffness;
  for (const AxleModel& axle : vehicle.axles) {
    stiffness.push_back(axle.x > vehicle.middle_x() ? kReferenceFrontTire : kReferenceRearTire);
  }
  return WithTireStiffness(vehicle, stiffness);
}

VehicleModel WithSteps(VehicleModel vehicle, double factor) {
  if (!(factor > 0)) throw InputError("step factor must be greater than 0");
  StepSizes& steps = vehicle.steps;
  steps.construction *= factor;
  steps.spring *= factor;
  steps.tire *= factor;
  return vehicle;
}

}  // namespace dbd
