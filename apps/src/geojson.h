#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <string>
#include <utility>
#include <vector>

namespace dbd {

// GeoJSON texts (RFC 7946): longitude, latitude [degrees, WGS84] and height above the elevation
// file's datum [m]. The frame must have a coordinate system.

/// The driven line of one rollout with its totals, tightest margins and the time at each position
/// (times_s) as properties.
std::string RouteGeoJson(const Rollout& rollout, const std::string& name, const LocalFrame& frame);

/// Every candidate's sampled line with what became of it, and the places where drives ended early.
std::string CandidatesGeoJson(const Plan& plan, const LocalFrame& frame);

}  // namespace dbd
