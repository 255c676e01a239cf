#include "time_steps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr double kSafety = 3.0;           // paper section 3: "dividing t_cr by a factor of 3"
constexpr double kQuantum = 0.5e-3;       // [s]
constexpr double kSlowestTire = 4e-3;     // [s] beyond it the sampled contact lags visibly
constexpr double kSlowestControl = 4e-3;  // [s]

/// Of a spring that pulls at `point` along `direction`: its moment m meets 1 / (m I^-1 m).
double RotationalStep(const BodyModel& body, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& direction, double stiffness) {
  const Eigen::Vector3d moment = point.cross(direction);
  if (moment.norm() < 1e-6) return std::numeric_limits<double>::infinity();
  return 1 / std::sqrt(stiffness * moment.dot(moment.cwiseQuotient(body.inertia)));
}

double RoundDown(double step) {
  return step < kQuantum ? step : kQuantum * std::floor(step / kQuantum + 1e-9);
}

}  // namespace

CriticalStep CriticalStepOf(const VehicleModel& vehicle, const LinkModel& link) {
  const BodyModel& a = vehicle.bodies[link.body_a];
  const BodyModel& b = vehicle.bodies[link.body_b];
  const Eigen::Vector3d direction = (b.p_RB + link.p_B - a.p_RB - link.p_A).normalized();
  return {std::sqrt(std::min(a.mass, b.mass) / link.stiffness),
          std::min(RotationalStep(a, link.p_A, direction, link.stiffness),
                   RotationalStep(b, link.p_B, direction, link.stiffness))};
}

StepSizes ChooseStepSizes(const VehicleModel& vehicle) {
  double construction = std::numeric_limits<double>::infinity();
  for (const LinkModel& link : vehicle.links) {
    const CriticalStep critical = CriticalStepOf(vehicle, link);
    construction = std::min({construction, critical.translational, critical.rotational});
  }
  double tire = std::numeric_limits<double>::infinity();
  for (const WheelModel& wheel : vehicle.wheels) {
    tire = std::min(tire, std::sqrt(vehicle.bodies[wheel.body].mass / wheel.tire.stiffness));
  }
  StepSizes steps;
  steps.construction = RoundDown(std::min(construction / kSafety, kSlowestTire));
  // A spring update costs little; holding its force would only add lag.
  steps.spring = steps.construction;
  // Only the contact's geometry is held at this rate, so the nearest multiple is safe.
  const double multiple = std::max(1.0, std::round(tire / kSafety / steps.construction));
  steps.tire = std::min(multiple * steps.construction, kSlowestTire);
  steps.control = kSlowestControl;
  SynchroniseSteps(steps);
  return steps;
}

void SynchroniseSteps(StepSizes& steps) {
  const auto multiple = [&](double group) {
    return steps.construction * std::max(1.0, std::floor(group / steps.construction + 1e-9));
  };
  steps.spring = multiple(steps.spring);
  steps.tire = multiple(steps.tire);
  steps.control = multiple(steps.control);
}

}  // namespace dbd
