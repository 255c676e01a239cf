#pragma once

namespace dbd {

/// How wrong a terrain may be.
struct TerrainSpread {
  double soil = 1;                    ///< factor on every material's `cone_index_spread`
  double elevation_error = 0;         ///< standard deviation of the heights [m]
  double elevation_correlation = 20;  ///< distance over which errors are alike [m]

  /// Throws InputError that names the field, its value and the rule.
  void Validate() const;
};

}  // namespace dbd
