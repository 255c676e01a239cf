#include "limit_units.h"

#include <dbd/core/units.h>

namespace dbd {

LimitUnit UnitOfLimit(const std::string& limit) {
  if (limit == "roll" || limit == "pitch" || limit == "slope") return {ToDegrees(1), "deg", "°"};
  if (limit == "sinkage" || limit == "clearance") return {1, "m", " m"};
  return {};
}

}  // namespace dbd
