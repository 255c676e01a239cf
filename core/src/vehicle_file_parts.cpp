#include "vehicle_file_parts.h"

namespace dbd {

using internal::JsonObject;

Eigen::Vector3d ReadInertia(const JsonObject& object) {
  const Eigen::Vector3d inertia = object.Point("inertia");
  const double sum = inertia.sum();
  if (inertia.minCoeff() <= 0) object.Fail("inertia", "must be positive in all three axes");
  if (inertia.maxCoeff() > sum - inertia.maxCoeff() + 1e-9) {
    object.Fail("inertia", "one moment is larger than the sum of the others: no body is like that");
  }
  return inertia;
}

StiffnessDamping ReadRate(const JsonObject& object) {
  return {object.Number("stiffness", kTiny, kMostStiffness),
          object.Number("damping", 0, kMostStiffness)};
}

StiffnessDamping ReadOwnRate(const JsonObject& parent, const std::string& key) {
  const JsonObject object = parent.Child(key);
  const StiffnessDamping rate = ReadRate(object);
  object.RefuseUnknownKeys();
  return rate;
}

DifferentialModel ReadDifferential(const JsonObject& object) {
  DifferentialModel differential;
  const std::string type = object.Text("type");
  if (type == "locked") {
    differential.type = DifferentialType::kLocked;
  } else if (type == "limited_slip") {
    differential.type = DifferentialType::kLimitedSlip;
    differential.bias_torque = object.Number("bias_torque", 0, 1e6);
  } else if (type != "open") {
    object.Fail("type", "is \"" + type + "\", must be open, limited_slip or locked");
  }
  object.RefuseUnknownKeys();
  return differential;
}

}  // namespace dbd
