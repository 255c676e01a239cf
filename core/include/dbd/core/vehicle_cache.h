#pragma once

#include <dbd/core/vehicle_model.h>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace dbd {

/// Vehicles that several requests share: the same file content is one object, read once. Safe to
/// use from many threads.
class VehicleCache {
 public:
  /// As `LoadVehicle`, and throws as it does.
  std::shared_ptr<const VehicleModel> Get(const std::string& name_or_file);

 private:
  static constexpr std::size_t kMost = 256;  // beyond this many all are forgotten

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const VehicleModel>> by_text_;
};

}  // namespace dbd
