#pragma once

#include <dbd/planner/plan_types.h>

#include <cstdint>
#include <string>

#include "places.h"
#include "terrain_options.h"

namespace dbd {

/// What `dbd plan` was asked, as typed.
struct PlanArguments {
  TerrainArguments terrain;
  std::string vehicle;
  std::string start;
  std::string goal;
  Coordinates coordinates = Coordinates::kMap;
  int candidates = SamplingOptions{}.candidates;
  int rounds = 3;
  double max_speed_kmh = 28.8;
  bool reversing = false;
  std::uint64_t seed = 1;
  int threads = 0;
  int draws = 1;
  double min_success = 0;
  double soil_spread = 1;
  double elevation_error_m = 0;
  double elevation_correlation_m = 20;
  double deadline_s = 0;  ///< of the whole command, without writing; 0: none
  std::string engine = "lanes";
  std::string out;
  bool json = false;
};

/// Throws InputError that names the option, its value and the rule.
PlanOptions MakePlanOptions(const PlanArguments& arguments);

/// Plans, writes all results or none, and prints the answer. Returns the exit code.
/// Throws InputError.
int RunPlan(const PlanArguments& arguments);

}  // namespace dbd
