#pragma once

namespace dbd {

// Sinkage and ruts on soil that a cone index describes. Loads in N, lengths in m, cone index in Pa.
// "Confidence" as in traction_relations.h.

/// One wheel and the soil below it.
struct WheelFooting {
  double cone_index = 0;
  double load = 0;
  double width = 0;
  double diameter = 0;
  double deflection_ratio = 0;  ///< hard-surface deflection / section height
};

/// Powered wheel on fine-grained soil at its self-propelled slip (Dettwiller et al. 2018):
/// z/d = 1.64 / (N_cz / s_sp^0.19)^1.21 with N_cz = CI b d / (W (1 - delta/h)^1.5), s_sp the
/// self-propelled slip 21/N_c^2.5 + 0.005, N_c = N_cz / (1 + b/d)^0.75. Confidence: one source.
double PoweredSinkage(double cone_index, double load, double width, double diameter,
                      double deflection_ratio);

/// Powered wheel at a given slip (WES/NRMM): z/d = 5 / (N_cz / |s|^0.2)^(5/3). Confidence:
/// provisional; within 0.6 to 21 % of the calibrated form where they were compared.
double PoweredSinkageAtSlip(const WheelFooting& wheel, double slip);

/// Towed wheel: z/d = 2.66/N_cz^1.64 - 0.0063, at least 0. Confidence: one source.
double UnpoweredSinkage(const WheelFooting& wheel);

/// First pass after Maclaurin 1990: z = 0.224 d / M^1.25 with the Turnage mobility number M.
/// Confidence: one source, which leaves open whose numeric is meant; they differ by 2 %.
double MaclaurinSinkage(double mobility, double diameter);

/// Rut after `passes` wheels in the same track: z_1 n^(1/a), a = 2-3 on loose, 3-4 on medium and
/// 4-5 on firm soil (Saarilahti 1991). Confidence: one source.
double MultipassSinkage(double first_sinkage, int passes, double exponent);

/// On sand: z/d = 14 / N_sp, N_sp = CI (b d)^1.5 / (W (1 - delta/h)) in psi, inches and pounds.
/// Confidence: low, one source with its units repaired; prefer `BekkerWheel`.
double SandSinkage(const WheelFooting& wheel);

/// Strength that the next wheel in the same rut finds, over that of the fresh soil: 1 + 1.8
/// e^(-0.11 B_n), at most 2 (Brixius 1987). Agricultural tilled soil only; wet fine-grained soil
/// loses strength instead. Not used unless asked for. Confidence: provisional.
double MultipassConeIndexRatio(double brixius_mobility);

struct SinkageOptions {
  /// Exponent a of `MultipassSinkage` for the wheels behind the first axle; 0 = no multipass: each
  /// wheel finds fresh soil, which is the default since following wheels rarely keep to the rut
  /// off-road and the law's exponent depends on the soil.
  double multipass_exponent = 0;
};

/// Sinkage of one wheel in operation: the larger of `PoweredSinkage` and `PoweredSinkageAtSlip`;
/// with multipass also of Maclaurin's first pass times the rut law for the `pass`-th wheel of the
/// track (1 = the foremost). 0 without load or soil.
double OperatingSinkage(const WheelFooting& wheel, double slip, int pass = 1,
                        const SinkageOptions& options = {});

}  // namespace dbd
