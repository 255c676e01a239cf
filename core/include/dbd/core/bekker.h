#pragma once

namespace dbd {

// Bekker's pressure-sinkage and Janosi & Hanamoto's shear relations, for soils that plate and shear
// tests describe. SI throughout: kc in N/m^(n+1), kphi in N/m^(n+2). Sources: Bekker 1969, Wong
// 2008. Confidence: p and tau one source, the wheel relations provisional.

/// What plate-sinkage and shear tests give.
struct BekkerSoil {
  double n = 1;                     ///< sinkage exponent
  double kc = 0;                    ///< cohesive modulus
  double kphi = 0;                  ///< frictional modulus; 0 = no plate data
  double cohesion = 0;              ///< c [Pa]
  double friction_angle = 0;        ///< phi [rad]
  double shear_deformation = 0.02;  ///< K of Janosi & Hanamoto [m]
};

/// Pressure under a plate of least dimension `width`: p = (kc/b + kphi) z^n.
double BekkerPressure(const BekkerSoil& soil, double width, double sinkage);

/// Its inverse.
double BekkerSinkage(const BekkerSoil& soil, double width, double pressure);

/// Rigid wheel: z = [3 W/((3-n)(kc + b kphi) sqrt(d))]^(2/(2n+1)), for n up to 1.3 and z < d/6.
double RigidWheelSinkage(const BekkerSoil& soil, double load, double width, double diameter);

/// Work of compaction per metre of rut: Rc = (kc + b kphi) z^(n+1)/(n+1).
double CompactionResistance(const BekkerSoil& soil, double width, double sinkage);

/// Janosi & Hanamoto 1961: tau = (c + p tan phi)(1 - e^(-j/K)), j the shear displacement.
double ShearStress(const BekkerSoil& soil, double pressure, double displacement);

/// Share of the shear strength that a contact of length L mobilises at slip s, with the
/// displacement growing from 0 to s L along it: f(x) = 1 - (1 - e^(-x))/x, x = s L/K at least 0.
double JanosiShare(double x);

/// Thrust of a contact: (A c + W tan phi) f(s L/K), odd in slip.
double JanosiThrust(const BekkerSoil& soil, double area, double load, double length, double slip);

/// A tire on such a soil.
struct BekkerWheelInput {
  double load = 0;
  double width = 0;
  double diameter = 0;
  double deflection = 0;  ///< on a hard surface
};
struct BekkerWheelForces {
  double sinkage = 0;
  double resistance = 0;      ///< compaction [N]
  double shear_strength = 0;  ///< A c + W tan phi [N]
  double contact_length = 0;
};
/// The simplification in use: the contact is the flat patch of the tire on a hard surface, L = 2
/// sqrt(R delta), A = b L; the wheel sinks until the soil carries the patch's mean pressure
/// ("elastic"), or as deep as a rigid wheel would, whichever is less, and at most to its hub. All
/// results go to 0 with the load.
BekkerWheelForces BekkerWheel(const BekkerSoil& soil, const BekkerWheelInput& wheel);

/// Cone index [Pa] with the cone's base at `depth` [m], from plate constants (Janosi & Wong;
/// leaves shear on the cone out, hence low for cohesive soil). Confidence: one source.
double ConeIndexFromBekker(const BekkerSoil& soil, double depth);

/// Mean of the readings at 0, 1, ... 6 in, as a penetrometer is read: the cone index of the top
/// 0.15 m that Brixius' relations ask for.
double MeanConeIndexFromBekker(const BekkerSoil& soil);

}  // namespace dbd
