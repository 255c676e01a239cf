#include <dbd/core/stability_relations.h>
#include <dbd/core/units.h>

#include <cmath>

namespace dbd {
namespace {

/// From the centre of mass to the edge of support.
double EdgeDistance(const SupportGeometry& support) {
  return std::hypot(0.5 * support.track, support.mass_center_height);
}

/// Of the line from the edge to the centre of mass against the normal of the support.
double EdgeAngle(const SupportGeometry& support) {
  return std::atan(StaticStabilityFactor(support));
}

}  // namespace

double StaticStabilityFactor(const SupportGeometry& support) {
  return support.track / (2 * support.mass_center_height);
}

double QuasiStaticLoadTransfer(const SupportGeometry& support, const LateralLoading& loading) {
  const double along = loading.lateral_acceleration + kGravity * std::sin(loading.bank);
  const double across = kGravity * std::cos(loading.bank) + loading.normal_acceleration;
  return along / (across * StaticStabilityFactor(support));
}

double SpeedForLoadTransfer(const SupportGeometry& support, double ratio, double curve_radius) {
  return std::sqrt(ratio * kGravity * StaticStabilityFactor(support) * curve_radius);
}

double EnergyMargin(const SupportGeometry& support, double tilt) {
  const double left = EdgeAngle(support) - tilt;
  return std::copysign(EdgeDistance(support) * (1 - std::cos(left)), left);
}

double ForceAngleMargin(const SupportGeometry& support, double lateral_acceleration) {
  const double at_rest = EdgeAngle(support);
  const double angle = at_rest - std::atan2(lateral_acceleration, kGravity);
  const double force = std::hypot(lateral_acceleration, kGravity);
  return angle * std::sin(std::abs(angle)) * force / (at_rest * std::sin(at_rest) * kGravity);
}

double BreakOverAngle(double wheelbase, double belly_height) {
  return 2 * std::atan(2 * belly_height / wheelbase);
}

double LeastCrestRadius(double wheelbase, double belly_height) {
  return wheelbase * wheelbase / (8 * belly_height) + 0.5 * belly_height;
}

double StepFriction(double wheel_radius, double step) {
  return std::tan(std::acos(1 - step / wheel_radius));
}

}  // namespace dbd
