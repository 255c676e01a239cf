#include <utility>

#include "file_formats.h"
#include "octree_file.h"

namespace dbd {

FileInfo DescribeOctreeFile(const std::string& file) {
  const std::unique_ptr<octomap::OcTree> tree = ReadOctree(file);
  FileInfo info;
  info.format = "OctoMap";
  OctreeFileInfo content;
  content.resolution = tree->getResolution();
  for (auto leaf = tree->begin_leafs(); leaf != tree->end_leafs(); ++leaf) {
    ++(tree->isNodeOccupied(*leaf) ? content.occupied_leaves : content.free_leaves);
    const Eigen::Vector3d center(leaf.getX(), leaf.getY(), leaf.getZ());
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * leaf.getSize());
    content.extent.Add(center - half);
    content.extent.Add(center + half);
  }
  if (content.occupied_leaves == 0) info.warnings.emplace_back("holds no occupied voxel");
  if (content.free_leaves == 0) {
    info.warnings.emplace_back("holds no free voxel: what is not occupied is unknown");
  }
  info.content = std::move(content);
  return info;
}

}  // namespace dbd
