#pragma once

namespace dbd {

/// Tires of the worked examples: T1 an 18.4-38 bias tractor tire, T2 and T3 the 25x8-12 and
/// 26x12-12 radial tires of a side-by-side.
struct TestTire {
  double width, diameter, load, deflection_ratio;
  double cone_index = 0, slip = 0;
};
constexpr TestTire kT1{0.467, 1.755, 25e3, 0.2, 900e3, 0.1};
constexpr TestTire kT2{0.2032, 0.635, 1456, 0.0224 / 0.1651, 300e3, 0.15};
constexpr TestTire kT3{0.3048, 0.6604, 2223, 0.02964 / 0.1778, 100e3, 0.2};
constexpr double kT2Deflection = 0.0224, kT3Deflection = 0.02964;

}  // namespace dbd
