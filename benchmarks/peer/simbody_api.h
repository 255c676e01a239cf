#pragma once

// Simbody's headers, for C++20. Its index types compare with integers only; C++20 also tries each
// of those operators reversed, so that comparing two indices becomes ambiguous. An operator that
// fits exactly settles it; it has to come before the headers.
namespace SimTK {

template <class Index>
requires requires(const Index& index) { index.isValidExtended(); }
bool operator==(const Index& a, const Index& b) {
  return static_cast<int>(a) == static_cast<int>(b);
}

}  // namespace SimTK

#include <Simbody.h>
