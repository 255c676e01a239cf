#pragma once

#include <numbers>

namespace dbd {

// Conversions to SI, used where files, flags and people come in. Inside everything is SI.

inline constexpr double kGravity = 9.81;  // [m/s^2], the paper's value

constexpr double Degrees(double degrees) { return degrees * std::numbers::pi / 180.0; }
constexpr double ToDegrees(double radians) { return radians * 180.0 / std::numbers::pi; }
constexpr double Kilopascals(double kpa) { return kpa * 1e3; }
constexpr double Psi(double psi) { return psi * 6894.757; }
constexpr double Inches(double inches) { return inches * 0.0254; }
constexpr double KilometersPerHour(double kmh) { return kmh / 3.6; }
constexpr double Rpm(double rpm) { return rpm * std::numbers::pi / 30.0; }
constexpr double ToRpm(double radians_per_second) {
  return radians_per_second * 30.0 / std::numbers::pi;
}

}  // namespace dbd
