#include <dbd/core/vehicle_cache.h>
#include <dbd/core/vehicle_database.h>

#include "vehicle_text.h"

namespace dbd {

std::shared_ptr<const VehicleModel> VehicleCache::Get(const std::string& name_or_file) {
  const std::string text = VehicleText(name_or_file);
  const std::lock_guard lock(mutex_);
  const auto found = by_text_.find(text);
  if (found != by_text_.end()) return found->second;
  const auto vehicle = ParseVehicle(text, name_or_file);
  if (by_text_.size() >= kMost) by_text_.clear();
  by_text_.emplace(text, vehicle);
  return vehicle;
}

}  // namespace dbd
