#pragma once

#include <string>

namespace dbd {

/// How a limit of the certificate is written for people: value [SI] * factor, then the unit.
struct LimitUnit {
  double factor = 1;
  const char* name = "";    ///< in files: "deg", "m", "" for a ratio
  const char* symbol = "";  ///< in text: "°", " m", ""
  int decimals = 2;         ///< in text
};

/// Angles become degrees, lengths stay metres, ratios have no unit.
LimitUnit UnitOfLimit(const std::string& limit);

}  // namespace dbd
