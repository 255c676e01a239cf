#pragma once

#include <string>
#include <vector>

#include "places.h"

namespace dbd {

/// One of the starts or goals of a matrix.
struct MatrixPlace {
  std::string name;
  TypedPlace place;
  Coordinates coordinates = Coordinates::kMap;
};

/// The places of `--<kind>s` (a file, may be empty) and then those of `--<kind>`, as typed in
/// `coordinates`. A place without a name is called by its number, one that was typed "<kind>1" and
/// so on. `kind`: "start" or "goal". Throws InputError when there is none, or a name is there
/// twice.
std::vector<MatrixPlace> ReadMatrixPlaces(const std::string& kind, const std::string& file,
                                          const std::vector<std::string>& typed,
                                          Coordinates coordinates);

/// Throws InputError when two names are the same.
void RefuseTwice(const std::string& flag, const std::vector<std::string>& names);

}  // namespace dbd
