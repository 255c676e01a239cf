#pragma once

#include <dbd/core/powertrain.h>

#include <cstdint>
#include <cstring>

namespace dbd {

/// FNV-1a over plain data, byte by byte.
class StateHasher {
 public:
  template <class Plain>
  void Add(const Plain& plain) {
    unsigned char bytes[sizeof(plain)];
    std::memcpy(bytes, &plain, sizeof(plain));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 1099511628211ull;
  }
  void Add(const PowertrainState& powertrain) {  // member by member: it has padding
    Add(powertrain.gear);
    Add(powertrain.time_in_gear);
    Add(powertrain.engine_torque);
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 1469598103934665603ull;
};

}  // namespace dbd
