#pragma once

#include <dbd/core/powertrain.h>

#include <cstdint>
#include <cstring>

#include "engine_state.h"

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
    Add(powertrain.reverse);
    Add(powertrain.time_in_gear);
    Add(powertrain.engine_torque);
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 1469598103934665603ull;
};

/// Over a whole state, bit by bit: bodies, wheels, contacts, frictions, powertrain.
inline std::uint64_t HashState(const EngineState<double>& state,
                               const PowertrainState& powertrain) {
  StateHasher hasher;
  for (const BodyState<double>& body : state.bodies) hasher.Add(body);
  for (const WheelState<double>& wheel : state.wheels) hasher.Add(wheel);
  for (const PointContactState<double>& contact : state.contacts) hasher.Add(contact);
  for (const double friction : state.frictions) hasher.Add(friction);
  hasher.Add(powertrain);
  return hasher.value();
}

}  // namespace dbd
