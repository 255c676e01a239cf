#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <filesystem>
#include <string>

namespace dbd {

// The driven line for other programs: WGS84, heights of the ground [m], times counted from
// 2000-01-01 00:00 UTC because a plan has no date. The frame must have a coordinate system. All
// throw InputError when the file cannot be written.

/// One track; each point with height and time.
void WriteGpx(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame);

/// One line with heights; its duration as an attribute.
void WriteKml(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame);

/// A layer "route" with the line (its measure is the time in seconds) and a layer "points" with
/// time and speed.
void WriteGeoPackage(const std::filesystem::path& file, const Rollout& rollout,
                     const std::string& name, const LocalFrame& frame);

}  // namespace dbd
