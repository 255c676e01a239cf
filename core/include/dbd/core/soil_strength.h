#pragma once

#include <optional>
#include <string>

namespace dbd {

// How strong a soil is and how strong it has to be: cone index, rating cone index, vehicle cone
// index. SI throughout (Pa, N, m, W); the published relations are in psi, pounds and inches and are
// converted inside. "Confidence" as in traction_relations.h.
//
// Cone index (CI) is what a penetrometer reads in undisturbed soil, rating cone index (RCI) what is
// left of it after remoulding by traffic. They are never mixed.

/// RCI = CI * remoulding index. Confidence: two sources.
double RatingConeIndex(double cone_index, double remoulding_index);

/// What the mobility index asks of a wheeled vehicle.
struct MobilityIndexVehicle {
  double weight = 0;  ///< [N]
  int axles = 0;
  int tires = 0;
  double tire_width = 0;
  double tire_diameter = 0;
  double clearance = 0;
  double power = 0;  ///< [W]
  bool automatic_transmission = true;
  bool chains = false;
};

/// Factors of the mobility index of wheeled vehicles on fine-grained soil (FM 5-430-00-1).
struct MobilityIndexFactors {
  double contact_pressure = 0;  ///< W / (b n d/2) [psi]
  double weight = 0;
  double tire = 0;          ///< (10 + b)/100 [in]
  double grouser = 1;       ///< 1.05 with chains
  double wheel_load = 0;    ///< [kip]
  double clearance = 0;     ///< [10 in]
  double engine = 1;        ///< 1.05 below 10 hp/ton
  double transmission = 1;  ///< 1.05 manual
};
MobilityIndexFactors FactorsOf(const MobilityIndexVehicle& vehicle);

/// Weight factor of a load per axle [N]: linear in four ranges. Confidence: one source; the first
/// range takes 0.553 x (some programs 0.533), which is the continuous choice.
double MobilityWeightFactor(double axle_load);

/// [CPF WF/(TF GF) + WLF - CF] EF TRF. Confidence: one source for the structure.
double MobilityIndex(const MobilityIndexFactors& factors);

/// One-pass vehicle cone index [Pa] of a wheeled vehicle with all axles driven (Priddy &
/// Willoughby 2006), times (0.15/(delta/h))^0.25. Confidence: two sources.
double VehicleConeIndexOnePass(double mobility_index, double deflection_ratio = 0.15);

/// Fifty-pass vehicle cone index [Pa], wheeled. Confidence: provisional.
double VehicleConeIndexFiftyPasses(double mobility_index);

/// The same of tracked vehicles. Confidence: provisional.
double TrackedConeIndexOnePass(double mobility_index);
double TrackedConeIndexFiftyPasses(double mobility_index);

/// Maclaurin 1997: N_M = CI b^0.8 d^0.8 delta^0.4 / W, and the least cone index [Pa] on which the
/// wheel moves itself, N_M = 1.85. Confidence: one source.
double MaclaurinNumeric(double cone_index, double load, double width, double diameter,
                        double deflection);
double LimitingConeIndex(double load, double width, double diameter, double deflection);

/// Curves of the soil-strength part of NRMM. Experimental: provisional coefficients, and which
/// curve belongs to which running gear could not be read again.
struct NrmmCurve {
  double a, c, e;                    ///< of the pull
  double resistance, slope, offset;  ///< of the motion resistance
};
/// Wheeled, contact pressure factor at least 4 psi, and below it.
inline constexpr NrmmCurve kNrmmHighPressure{0.3885, 0.0265, 0.0358, 0.045, 2.3075, 6.5};
inline constexpr NrmmCurve kNrmmLowPressure{0.544, 0.0463, 0.0702, 0.035, 0.861, 3.249};
/// Drawbar pull / weight at `excess` = RCI - VCI1 [Pa], at least 0; atan of it is the grade limit.
double NrmmPullRatio(const NrmmCurve& curve, double excess);
double NrmmResistanceRatio(const NrmmCurve& curve, double excess);

/// Soils of the Unified Soil Classification System that have moisture relations.
enum class UscsClass { kSW, kSP, kSM, kSC, kSMSC, kML, kCLML, kCL, kOL, kCH, kMH, kOH };
/// "CL-ML" -> kCLML; none for a name that is not in the list.
std::optional<UscsClass> UscsClassOf(const std::string& name);
std::string UscsName(UscsClass soil);

struct SoilStrength {
  double cone_index = 0;
  double rating_cone_index = 0;
};
/// exp(c1 + c2 ln w) psi at the gravimetric moisture `moisture` [% of dry weight] (Sullivan et al.
/// 1997, SMSP II), as fitted. Confidence: two sources for the magnitudes; the slope of CH is
/// repaired from a misprint in both (5.583 -> 2.583).
SoilStrength FittedSoilStrength(UscsClass soil, double moisture);

/// The same kept to where the fits make sense: 1 to 300 psi, and RCI not above CI except in clean
/// sand.
SoilStrength SoilStrengthAt(UscsClass soil, double moisture);

/// How wet a soil is: 12, 22 and 35 % of its dry weight; 10 % more in CH, MH and OH, which hold
/// more water. The percentages are a choice inside the range of the fits.
enum class MoistureState { kDry, kMoist, kWet };
/// "wet" -> kWet; none for any other name.
std::optional<MoistureState> MoistureStateOf(const std::string& name);

/// Cone index in a state over that of the same soil when moist, both by `SoilStrengthAt`.
double MoistureFactor(UscsClass soil, MoistureState state);

/// Cross-country speed of a movement map after FM 5-33: off-road slope limits the speed, and
/// contour crossings, vegetation, soil and roughness each take a share.
struct MovementFactors {
  double slope = 0;               ///< grade [-]
  double max_off_road_slope = 0;  ///< grade [-]
  double max_on_road_slope = 0;   ///< grade [-]
  double max_road_speed = 0;      ///< [m/s]
  double contour_crossings = 0;   ///< mean, on the diagonals of a square kilometre
  double vegetation = 1;          ///< share left, as the next two
  double soil = 1;
  double roughness = 1;
};
/// [m/s], at least 0. Confidence: one source.
double MovementSpeed(const MovementFactors& factors);

}  // namespace dbd
