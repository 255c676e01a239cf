#pragma once

namespace dbd::internal {

/// A place in cells, held between 0 and `last`; not a number, as a vehicle that diverged asks for,
/// becomes 0. Written so that it compiles to a maximum and a minimum.
inline double ClampIndex(double index, double last) {
  const double not_below = index > 0.0 ? index : 0.0;
  return not_below < last ? not_below : last;
}

}  // namespace dbd::internal
