#include "limit_units.h"

#include <dbd/core/units.h>

namespace dbd {

LimitUnit UnitOfLimit(const std::string& limit) {
  if (limit == "roll" || limit == "pitch" || limit == "slope") return {ToDegrees(1), "deg", "°", 1};
  if (limit == "sinkage" || limit == "clearance") return {1, "m", " m", 3};
  return {};
}

}  // namespace dbd
