#pragma once

#include <dbd/core/vehicle_model.h>

namespace dbd {

// Tire-soil relations as plain functions of plain numbers, so that a published table is a test.
// Loads in N, lengths in m, cone index in Pa, ratios per wheel load. The engine evaluates the same
// formulas in its own number type.

/// Wheel numeric C_n = CI b d / W.
double WheelNumeric(double cone_index, double load, double width, double diameter);

/// Brixius mobility number B_n, not capped.
double BrixiusMobilityNumber(double cone_index, double load, double width, double diameter,
                             double deflection_ratio);

/// The coefficient sets of bias and radial tires (Zoz & Grisso 2003). Confidence: bias one source,
/// radial provisional: 9.5 is the middle of the 8.5-10.5 in use.
BrixiusCoefficients BiasCoefficients();
BrixiusCoefficients RadialCoefficients();

/// Gross traction / load: axle torque = r GTR W. Odd in slip except for the carcass term.
double GrossTractionRatio(const BrixiusCoefficients& coefficients, double mobility, double slip);

/// Motion resistance / load, even in slip.
double MotionResistanceRatio(const BrixiusCoefficients& coefficients, double mobility, double slip);

/// Net traction / load = GTR - MRR: hub force = NTR W.
double NetTractionRatio(const BrixiusCoefficients& coefficients, double mobility, double slip);

struct NetTractionOptimum {
  double ratio = 0;
  double slip = 0;
};
/// Largest net traction over slips in [0, 1].
NetTractionOptimum MaxNetTraction(const BrixiusCoefficients& coefficients, double mobility);

/// Slip (travel reduction), the one definition in dbd: (u - v) / max(|u|, |v|, floor) with the
/// peripheral speed u = r w and the forward speed v. Driving forward it is 1 - v/u (ASABE S296).
double Slip(double peripheral_speed, double forward_speed, double floor_speed = 0.1);

/// Rolling radius from unloaded radius and deflection.
double LoadedRollingRadius(double radius, double deflection);

/// Vertical stiffness of a rolling agricultural tire [N/m] (Lines & Murphy 1991):
/// k [kN/m] = 172 - 1.77 rim [in] + 5.6 age [y] + 0.34 rim [in] width [in] pressure [bar].
double LinesMurphyStiffness(double rim_diameter, double width, double pressure,
                            double age_years = 0);

}  // namespace dbd
