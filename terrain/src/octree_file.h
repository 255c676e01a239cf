#pragma once

#include <octomap/OcTree.h>

#include <memory>
#include <string>

namespace dbd {

/// Reads an occupancy octree (.bt or .ot, tree type OcTree). OctoMap trusts its files: it prints
/// what it dislikes, and a damaged one makes it recurse without end. So header and structure are
/// checked here first, and OctoMap sees only what it can read.
/// Throws InputError that names the file and what is wrong with it.
std::unique_ptr<octomap::OcTree> ReadOctree(const std::string& file);

}  // namespace dbd
