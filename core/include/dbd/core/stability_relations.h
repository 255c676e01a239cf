#pragma once

namespace dbd {

// Stability against tipping and clearance over obstacles, as plain functions of plain numbers:
// statics and geometry of a rigid vehicle. The engine's own measure is the load transfer ratio of
// the tire forces; these are for screening places and for comparison. Lengths in m, angles in rad,
// accelerations in m/s^2.

/// Track and height of the centre of mass above the contact plane.
struct SupportGeometry {
  double track = 0;
  double mass_center_height = 0;
};

/// T / 2h, the tangent of the tilt angle at which a side lifts (NHTSA).
double StaticStabilityFactor(const SupportGeometry& support);

/// What presses a vehicle on its support: lateral acceleration in a curve, bank angle of the ground
/// (positive where it adds to the lateral acceleration), acceleration along the ground's normal.
struct LateralLoading {
  double lateral_acceleration = 0;
  double bank = 0;
  double normal_acceleration = 0;
};

/// Quasi-static load transfer ratio (2h/T)(a_y + g sin b)/(g cos b + a_z): 1 = a side lifts.
double QuasiStaticLoadTransfer(const SupportGeometry& support, const LateralLoading& loading);

/// Speed on a level curve at which the quasi-static load transfer ratio is `ratio` [m/s].
double SpeedForLoadTransfer(const SupportGeometry& support, double ratio, double curve_radius);

/// Normalised energy stability margin [m]: how far the centre of mass rises, R (1 - cos theta), to
/// stand over the lower edge of support, on ground tilted by `tilt` towards that edge. Negative
/// beyond the edge. After Papadopoulos & Rey 1996, Garcia & de Santos 2005.
double EnergyMargin(const SupportGeometry& support, double tilt);

/// Force-angle measure theta d |f| per mass under a lateral acceleration, over its value at rest: 1
/// at rest, 0 where the force points at the edge (Papadopoulos & Rey 1996).
double ForceAngleMargin(const SupportGeometry& support, double lateral_acceleration);

/// Largest angle between two planes that a belly passes over: 2 atan(2c/L).
double BreakOverAngle(double wheelbase, double belly_height);

/// Least radius of a crest that a belly passes over: L^2/(8c) + c/2.
double LeastCrestRadius(double wheelbase, double belly_height);

/// Least friction with which a driven wheel climbs a step without being pushed: tan(acos(1 - H/r)).
/// `step` below the radius.
double StepFriction(double wheel_radius, double step);

}  // namespace dbd
