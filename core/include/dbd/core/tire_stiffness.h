#pragma once

namespace dbd {

// Vertical stiffness of tires where Lines & Murphy (terramechanics.h) does not hold. SI.
// "Confidence" as in traction_relations.h.

/// Stiffness [N/m] of a tire that deflects by 16 % of its section height at its rated load.
/// Confidence: one source.
double LoadRatingStiffness(double rated_load, double section_height);

/// Damping [N s/m] of a share `ratio` of critical for a wheel mass: c = 2 ratio sqrt(k m).
double TireDamping(double stiffness, double wheel_mass, double ratio);

/// Deflection [m] of a forest tire: 0.0008 + 0.001 (0.365 + 170/p [kPa]) W [kN] (Saarilahti 2002).
/// Confidence: one source.
double ForestTireDeflection(double load, double pressure);

/// k [N/m] = p [Pa] + 150000: one military tire of 0.565 m radius. Confidence: one source.
double PressureLineStiffness(double pressure);

/// Stiffness that grows as the tire bottoms: k h / max(0.1 h, h - delta). Confidence: one source.
double ProgressiveStiffness(double stiffness, double section_height, double deflection);

}  // namespace dbd
