#pragma once

#include <dbd/core/internal/json_object.h>
#include <dbd/core/vehicle_model.h>

#include "suspension.h"

namespace dbd {

// What several parts of a vehicle file have in common.

inline constexpr double kMostMass = 1e5;       // [kg]
inline constexpr double kMostLength = 50;      // [m]
inline constexpr double kMostStiffness = 1e9;  // [N/m]
inline constexpr double kTiny = 1e-6;          // stands for "greater than zero"

Eigen::Vector3d ReadInertia(const internal::JsonObject& object);

/// "stiffness" and "damping" of an object, or of its child `key`.
StiffnessDamping ReadRate(const internal::JsonObject& object);
StiffnessDamping ReadOwnRate(const internal::JsonObject& parent, const std::string& key);

DifferentialModel ReadDifferential(const internal::JsonObject& object);

}  // namespace dbd
