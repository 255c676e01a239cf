#pragma once

namespace dbd {

// Alternatives to Brixius for traction, and the relations for lateral force and combined slip, as
// plain functions of plain numbers: loads in N, lengths in m, cone index in Pa, angles in rad,
// ratios per wheel load. "Confidence" says how sure the coefficients are: "two sources", "one
// source", or "provisional" where the original could not be read.

struct TractionRatios {
  double gross = 0;       ///< axle torque / (rolling radius * load)
  double resistance = 0;  ///< motion resistance / load
  double net = 0;         ///< hub force / load
};

/// Wismer & Luth 1973: GTR = 0.75 (1 - e^(-0.3 C_n s)), MRR = 1.2/C_n + 0.04. For b/d about 0.3,
/// delta/h about 0.2, bias tires, C_n 10-60; no deflection term. Odd in slip (a convention).
/// Confidence: one source, agrees with the usual citation.
TractionRatios WismerLuthTraction(double wheel_numeric, double slip);

/// WES mobility number for clay (Turnage): M = (CI b d / W) sqrt(delta/h) / (1 + b/(2d)).
/// Confidence: two sources.
double TurnageMobilityNumber(double cone_index, double load, double width, double diameter,
                             double deflection_ratio);

/// Gee-Clough et al. 1978 (NIAE), for M = 2-30 on cultivated soil.
struct GeeCloughTraction {
  double max_net = 0;           ///< 0.796 - 0.92/M, positive above M = 1.1558
  double rate = 0;              ///< K with K max_net = 4.838 + 0.061 M
  double net = 0;               ///< net pull of a driven wheel: max_net (1 - e^(-K s))
  double towed_resistance = 0;  ///< 0.049 + 0.287/M
};
/// `slip` in [0, 1]. Confidence: provisional.
GeeCloughTraction GeeCloughNetTraction(double mobility, double slip);

/// Numerics of the ERDC/VTI fine-grained relations.
struct ClayNumerics {
  double uncorrected = 0;          ///< N_cz = CI b d / (W (1 - delta/h)^1.5)
  double numeric = 0;              ///< N_c = N_cz / (1 + b/d)^0.75
  double self_propelled_slip = 0;  ///< 21/N_c^2.5 + 0.005: where the net pull is zero
};
ClayNumerics FineGrainedNumerics(double cone_index, double load, double width, double diameter,
                                 double deflection_ratio);

/// Dettwiller et al. 2018: net = 0.5 lg(s/s_sp) (1 + b/d)^0.25, MRR = 12/N_c^2 + 0.007, gross their
/// sum. Unusable without slip: `slip` above 0. Confidence: one source.
TractionRatios FineGrainedTraction(const ClayNumerics& numerics, double width, double diameter,
                                   double slip);

/// The same authors for a towed wheel: 5.07/N_c^1.71 + 0.011.
double FineGrainedTowedResistance(const ClayNumerics& numerics);

/// Cone index gradient of sand [N/m^3] whose mean over the top 0.15 m is `cone_index`:
/// G [psi/in] = CI [psi] / 3.47. Confidence: one source, units repaired.
double SandGradient(double cone_index);

/// N_s = G (b d)^1.5 (delta/h) / W. Confidence: one source.
double SandNumeric(double gradient, double load, double width, double diameter,
                   double deflection_ratio);

/// Gross traction ratio on sand, X - X Y/(N_s + 10 + Y), X = 0.66, Y = 4.71 + 1.72/s; `slip` in
/// [0, 1], written so that it is 0 without slip. Confidence: one source.
double SandGrossTraction(double sand_numeric, double slip);

/// Lateral force / load = limit (1 - e^(-rate |alpha|)), Crolla & El-Razaz 1987.
struct LateralCoefficients {
  double limit = 0;
  double rate = 0;  ///< [1/rad]
};

/// Gee-Clough & Sommer 1981, undriven angled wheels on soil of Turnage mobility M (above about 2):
/// bias: limit 0.61 + 0.69/M (at most 1), rate (2.34 + 0.088 M)/limit; radial: limit 0.8, rate
/// (2.79 + 0.16 M)/limit. Confidence: one source.
LateralCoefficients BiasLateralCoefficients(double mobility);
LateralCoefficients RadialLateralCoefficients(double mobility);

/// Magnitude of lateral force / load at slip angle `angle` [rad].
double LateralForceRatio(const LateralCoefficients& coefficients, double angle);

/// Traction ellipse (Janosi, Kamm & Wray 1981): what is left of the lateral force `lateral` while
/// the shear part of traction uses `traction` of `traction_limit`. Confidence: two sources that an
/// ellipse is assumed; the reduction is its standard form.
double EllipseLateralForce(double lateral, double traction, double traction_limit);

struct CombinedForces {
  double longitudinal = 0;
  double lateral = 0;
};
/// What the Nicolas-Comstock law combines (Brach & Brach 2009, 2011).
struct PureSlipForces {
  double longitudinal = 0;            ///< F_x0(s) [N]
  double lateral = 0;                 ///< F_y0(alpha) [N]
  double longitudinal_stiffness = 0;  ///< dF_x/ds at 0 [N]
  double lateral_stiffness = 0;       ///< dF_y/dalpha at 0 [N/rad]
};
/// `slip` in (0, 1), `angle` in (0, pi/2) [rad]. Confidence: one source, a stray factor removed.
CombinedForces NicolasComstockForces(const PureSlipForces& pure, double slip, double angle);

/// Length of a tire's contact, L = 2 sqrt(R delta).
double ContactLength(double radius, double deflection);

/// Pneumatic trail n = 0.178 L (1 - |s_y|/0.365), 0 beyond: the aligning torque is -n F_y. From
/// truck tire data on road; confidence: one source.
double PneumaticTrail(double contact_length, double lateral_slip);

}  // namespace dbd
