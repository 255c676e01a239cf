#include <dbd/core/mobility.h>
#include <dbd/core/sinkage.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

#include "brixius.h"

namespace dbd {
namespace {

double StaticMobility(const WheelModel& wheel, const SoilSample& soil) {
  const TireModel& tire = wheel.tire;
  return std::min(
      kHardSoilMobility,
      BrixiusMobilityNumber(soil.cone_index, wheel.static_load, tire.width, 2 * tire.radius,
                            wheel.static_load / tire.stiffness / tire.section_height));
}

double WheelNetTraction(const WheelModel& wheel, bool driven, const SoilSample& soil) {
  const BrixiusCoefficients& c = wheel.tire.traction;
  const double mobility = StaticMobility(wheel, soil);
  if (!driven) return -MotionResistanceRatio(c, mobility, 0);
  const NetTractionOptimum best = MaxNetTraction(c, mobility);
  // A friction limit below the soil's capacity cuts the gross part only.
  const double excess = std::max(0.0, TractionCapacity(c, mobility) - soil.friction_limit);
  return best.ratio - excess;
}

}  // namespace

double MaxNetTractionRatio(const VehicleModel& vehicle, const SoilSample& soil) {
  double force = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    force += wheel.static_load * WheelNetTraction(wheel, vehicle.axles[wheel.axle].driven, soil);
  }
  return force / (vehicle.total_mass() * kGravity);
}

double StaticSinkage(const VehicleModel& vehicle, const SoilSample& soil) {
  double deepest = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    const TireModel& tire = wheel.tire;
    deepest = std::max(
        deepest, PoweredSinkage(soil.cone_index, wheel.static_load, tire.width, 2 * tire.radius,
                                wheel.static_load / tire.stiffness / tire.section_height));
  }
  return deepest;
}

double StaticStabilityAngle(const VehicleModel& vehicle) {
  return std::atan(vehicle.mean_track() / (2 * vehicle.mass_center_height()));
}

}  // namespace dbd
