#pragma once

#include <dbd/terrain/file_info.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace dbd {

/// Reads lines "x y z" (blanks, tabs, commas or semicolons between; # begins a comment; a first
/// line of words is a header; further columns are ignored).
/// Throws InputError that names the file, the line and what is wrong with it.
std::vector<Eigen::Vector3d> ReadXyz(const std::string& file);

/// What the header of a PCD or LAS/LAZ file states. The points of LAZ are compressed.
PointFileInfo ReadPcdHeader(const std::string& file);
PointFileInfo ReadLasHeader(const std::string& file);

}  // namespace dbd
