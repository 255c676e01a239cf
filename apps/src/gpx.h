#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <filesystem>
#include <string>

namespace dbd {

/// Writes the driven line as a GPX track with ground heights. The frame must have a coordinate
/// system. Throws InputError when the file cannot be written.
void WriteGpx(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame);

}  // namespace dbd
