#include "limit_units.h"

#include <dbd/core/units.h>

namespace dbd {

LimitUnit UnitOfLimit(const std::string& limit) {
  if (limit == "roll" || limit == "pitch" || limit == "slope") return {ToDegrees(1), "deg", "°", 1};
  if (limit == "sinkage" || limit == "clearance") return {1, "m", " m", 3};
  if (limit == "absorbed_power") return {1, "W", " W", 1};
  if (limit == "shock") return {1 / kGravity, "g", " g", 2};
  return {};
}

}  // namespace dbd
