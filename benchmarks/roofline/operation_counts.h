#pragma once

#include <array>
#include <cstdint>

namespace dbd {

/// What a counting number tells apart.
enum class Operation {
  kAdd,  ///< and subtract
  kMultiply,
  kDivide,
  kSquareRoot,
  kExponential,
  kCubeRoot,
  kCompare,
  kExtreme,  ///< minimum, maximum
  kSelect,
  kAbsolute,
  kConvert,     ///< to a whole number or back
  kFused,       ///< additions that could be one instruction with a multiplication before them
  kLoad,        ///< of a number that is kept in state or workspace
  kStore,       ///< to there
  kConstant,    ///< of the model or the program, the same for all lanes
  kHeightRead,  ///< four corners of a cell: 16 bytes per vehicle
  kBoundRead,   ///< highest ground nearby
  kSoilRead,    ///< soil under a wheel: in scalar code, vehicle by vehicle
};
inline constexpr std::size_t kOperations = 18;

struct OperationCounts {
  std::array<double, kOperations> number{};

  double& operator[](Operation operation) { return number[static_cast<std::size_t>(operation)]; }
  double operator[](Operation operation) const {
    return number[static_cast<std::size_t>(operation)];
  }
  OperationCounts& operator+=(const OperationCounts& other);
  OperationCounts& operator*=(double factor);
};

/// With exponentials and cube roots in the place of which stands what float packs do for them.
OperationCounts Expanded(const OperationCounts& counts);

// Of expanded counts:

/// Additions, multiplications, divisions, square roots.
double Flops(const OperationCounts& counts);
/// All that runs on the same units as additions and multiplications: all but divisions and roots.
double SimpleOperations(const OperationCounts& counts);

}  // namespace dbd
