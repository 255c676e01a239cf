#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <string>
#include <utility>
#include <vector>

namespace dbd {

// GeoJSON texts (RFC 7946): longitude, latitude [degrees, WGS84] and height above the elevation
// file's datum [m]. The frame must have a coordinate system.

/// A driven line for a file of several.
struct NamedRoute {
  std::string name;
  std::vector<std::pair<std::string, std::string>> labels;  ///< further properties
  const Rollout* rollout = nullptr;
};

/// The driven lines with their totals, tightest margins and the time at each position (times_s) as
/// properties.
std::string RoutesGeoJson(const std::vector<NamedRoute>& routes, const std::string& name,
                          const LocalFrame& frame);

/// The same of one line.
std::string RouteGeoJson(const Rollout& rollout, const std::string& name, const LocalFrame& frame);

/// Every candidate's sampled line with what became of it, and the places where drives ended early.
std::string CandidatesGeoJson(const Plan& plan, const LocalFrame& frame);

}  // namespace dbd
