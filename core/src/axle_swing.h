#pragma once

#include <dbd/core/vehicle_model.h>

#include <optional>

namespace dbd {

/// How a beam axle rolls against the body that carries it, from its links, springs and joints in
/// the design pose, everything else giving way as it may.
struct AxleSwing {
  double stiffness = 0;                                ///< in roll [N m/rad]
  Eigen::Vector3d center_R = Eigen::Vector3d::Zero();  ///< it turns about the x axis through here
};

/// None for an axle whose wheels hang on bodies of their own.
std::optional<AxleSwing> SwingOf(const VehicleModel& vehicle, const AxleModel& axle);

/// Whether the axle swings on a pivot: it carries its load but passes on no roll moment to speak
/// of.
bool SwingsFreely(const VehicleModel& vehicle, const AxleModel& axle);

}  // namespace dbd
