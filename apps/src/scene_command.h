#pragma once

#include <string>

namespace dbd {

/// Flags of `dbd scenario convoy` and `dbd scenario road-train`.
struct SceneArguments {
  bool road_train = false;  ///< else a convoy
  std::string vehicle;      ///< empty: tomcar-tm27, of a road train tractor
  int vehicles = 8;         ///< of a convoy
  std::string trailer = "farm-trailer";
  int trailers = 2;
  double target_speed = 0;  ///< [m/s], 0 = the scenario's
  double time_gap = 1.5;    ///< [s]
  std::string terrain;      ///< other ground: .csv grid or elevation raster
  std::string out;          ///< CSV file to write
  std::string plots;        ///< directory for pictures
  int threads = 0;          ///< 0: all
};

/// Drives a scene of many vehicles and prints what it was like. Throws InputError.
int RunScene(const SceneArguments& arguments);

}  // namespace dbd
