#include <dbd/core/mobility.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/traction_relations.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

#include "axle_swing.h"
#include "brixius.h"
#include "soil_rule.h"

namespace dbd {
namespace {

double StaticMobility(const WheelModel& wheel, const SoilSample& soil) {
  const TireModel& tire = wheel.tire;
  return std::min(
      kHardSoilMobility,
      BrixiusMobilityNumber(soil.cone_index, wheel.static_load, tire.width, 2 * tire.radius,
                            wheel.static_load / tire.stiffness / tire.section_height));
}

double BrixiusNetTraction(const WheelModel& wheel, bool driven, const SoilSample& soil) {
  const BrixiusCoefficients& c = wheel.tire.traction;
  const double mobility = StaticMobility(wheel, soil);
  if (!driven) return -MotionResistanceRatio(c, mobility, 0);
  const NetTractionOptimum best = MaxNetTraction(c, mobility);
  // A friction limit below the soil's capacity cuts the gross part only.
  const double excess = std::max(0.0, TractionCapacity(c, mobility) - soil.friction_limit);
  return best.ratio - excess;
}

/// Traction of the other models grows with slip throughout: the most is at full slip.
double WismerLuthNetTraction(const WheelModel& wheel, bool driven, const SoilSample& soil) {
  const TireModel& tire = wheel.tire;
  const double numeric =
      std::min(kHardSoilMobility,
               WheelNumeric(soil.cone_index, wheel.static_load, tire.width, 2 * tire.radius));
  const TractionRatios ratios = WismerLuthTraction(numeric, driven ? 1 : 0);
  return ratios.gross * std::min(1.0, soil.friction_limit / 0.75) - ratios.resistance;
}

double BekkerNetTraction(const WheelModel& wheel, bool driven, const SoilSample& soil) {
  const TireModel& tire = wheel.tire;
  const SoilRule<double> rule =
      BekkerRule(soil.plate, {tire.width, 2 * tire.radius, tire.stiffness},
                 wheel.static_load / tire.stiffness);
  if (!driven) return -rule.resistance - tire.traction.carcass_loss;
  return std::min(rule.capacity, soil.friction_limit) - rule.resistance;
}

double WheelNetTraction(const WheelModel& wheel, bool driven, const SoilSample& soil) {
  switch (soil.traction_model) {
    case TractionModel::kBrixius:
      return BrixiusNetTraction(wheel, driven, soil);
    case TractionModel::kWismerLuth:
      return WismerLuthNetTraction(wheel, driven, soil);
    case TractionModel::kBekker:
      return BekkerNetTraction(wheel, driven, soil);
  }
  return 0;
}

}  // namespace

double MaxNetTractionRatio(const VehicleModel& vehicle, const SoilSample& soil) {
  double force = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    force += wheel.static_load * WheelNetTraction(wheel, vehicle.axles[wheel.axle].driven, soil);
  }
  return force / (vehicle.total_mass() * kGravity);
}

double WheelSinkage(const TireModel& tire, const SoilSample& soil, double load, double deflection,
                    double slip, int pass, const SinkageOptions& options) {
  if (soil.traction_model == TractionModel::kBekker) {
    return BekkerWheel(soil.plate, {load, tire.width, 2 * tire.radius, deflection}).sinkage;
  }
  const WheelFooting footing{soil.cone_index, load, tire.width, 2 * tire.radius,
                             deflection / tire.section_height};
  return OperatingSinkage(footing, slip, pass, options);
}

double StaticSinkage(const VehicleModel& vehicle, const SoilSample& soil) {
  double deepest = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    const double load = wheel.static_load;
    deepest =
        std::max(deepest, WheelSinkage(wheel.tire, soil, load, load / wheel.tire.stiffness, 0));
  }
  return deepest;
}

namespace {

/// A vehicle on one firm axle and one that swings tips over the line from the firm axle's lower
/// contact to the pivot, and leaves the swinging axle behind on the ground.
double TippingAngle(const VehicleModel& vehicle, const AxleModel& firm, const AxleModel& swinging) {
  const int left_behind = vehicle.wheels[static_cast<std::size_t>(swinging.left)].body;
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
    if (static_cast<int>(i) == left_behind) continue;
    mass += vehicle.bodies[i].mass;
    moment += vehicle.bodies[i].mass * vehicle.bodies[i].p_RB;
  }
  const Eigen::Vector3d center = moment / mass, pivot = SwingOf(vehicle, swinging)->center_R;
  const double along = (center.x() - firm.x) / (pivot.x() - firm.x);
  const double offset = 0.5 * firm.track * (1 - along);
  const double line_height = (vehicle.reference_height + pivot.z()) * along;
  return std::atan2(offset, vehicle.reference_height + center.z() - line_height);
}

}  // namespace

double StaticStabilityAngle(const VehicleModel& vehicle) {
  if (vehicle.axles.size() == 2) {
    for (int firm : {0, 1}) {
      const AxleModel& axle = vehicle.axles[static_cast<std::size_t>(firm)];
      const AxleModel& other = vehicle.axles[static_cast<std::size_t>(1 - firm)];
      if (!SwingsFreely(vehicle, axle) && SwingsFreely(vehicle, other)) {
        return TippingAngle(vehicle, axle, other);
      }
    }
  }
  return std::atan(vehicle.mean_track() / (2 * vehicle.mass_center_height()));
}

}  // namespace dbd
