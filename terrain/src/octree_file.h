#pragma once

#include <octomap/OcTree.h>

#include <iosfwd>
#include <memory>
#include <string>

namespace dbd {

/// Reads an occupancy octree (.bt or .ot, tree type OcTree). OctoMap trusts its files: it prints
/// what it dislikes, and a damaged one makes it recurse without end. So header and structure are
/// checked here first, and OctoMap sees only what it can read.
/// Throws InputError that names the file and what is wrong with it.
std::unique_ptr<octomap::OcTree> ReadOctree(const std::string& file);

/// Writes a .bt file's bytes; occupancy is reduced to occupied or free and leaves are merged first.
/// OctoMap's own function reports on the error stream.
void WriteOctree(octomap::OcTree& tree, std::ostream& stream);

}  // namespace dbd
