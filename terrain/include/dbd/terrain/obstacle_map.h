#pragma once

#include <dbd/terrain/height_map.h>
#include <dbd/terrain/local_frame.h>

#include <cstddef>
#include <string>
#include <vector>

namespace dbd {

/// Obstacles from one source, over the ground: for each cell the lowest occupied height above the
/// ground that is not the ground itself.
class ObstacleLayer {
 public:
  /// `lowest`: rows x columns, row 0 south; height above ground of the lowest occupied voxel's
  /// bottom at or above `floor` [m], infinity where free. A cell is a square round its centre.
  ObstacleLayer(const HeightMap::Grid& grid, std::vector<float> lowest);

  /// Something less than `height` [m] above the ground stands in the rectangle with this centre,
  /// heading [rad] and half extents [m].
  bool BlocksBox(const Eigen::Vector2d& center, double heading, const Eigen::Vector2d& half_extents,
                 double height) const;

  /// Cells that hold an obstacle below `height`.
  std::size_t BlockedCells(double height) const;

  const HeightMap::Grid& grid() const { return grid_; }
  std::size_t memory_bytes() const { return lowest_.size() * sizeof(float); }

 private:
  HeightMap::Grid grid_;
  std::vector<float> lowest_;
};

/// Obstacles of all sources (an OctoMap, a surface model), each a layer on a grid of its own; what
/// stands in any of them is in the way. Empty when there are none.
class ObstacleMap {
 public:
  ObstacleMap() = default;

  /// One layer, as `ObstacleLayer`.
  ObstacleMap(const HeightMap::Grid& grid, std::vector<float> lowest);

  /// Takes the layers of another map too.
  void Add(ObstacleMap other);

  bool empty() const { return layers_.empty(); }

  /// Something occupied stands less than `height` [m] above the ground at this place.
  bool Blocks(double x, double y, double height) const;

  /// The same anywhere in the rectangle with this centre, heading [rad] and half extents [m].
  bool BlocksBox(const Eigen::Vector2d& center, double heading, const Eigen::Vector2d& half_extents,
                 double height) const;

  /// Share of the cells of all layers that hold an obstacle below `height`.
  double BlockedShare(double height) const;

  const std::vector<ObstacleLayer>& layers() const { return layers_; }
  std::size_t memory_bytes() const;

 private:
  std::vector<ObstacleLayer> layers_;
};

/// What space is that an OctoMap has not seen.
enum class UnknownSpace {
  kFree,     ///< only what is occupied is in the way
  kBlocked,  ///< what is not known to be free is in the way
};

/// Reads a .bt or .ot file (an OcTree) and projects it on the ground. Occupied voxels whose bottom
/// is less than `floor` [m] above the ground, at the middle of their cell, count as ground.
/// `placement`: where the octree lies in W; its z is the height in W. The layer has the octree's
/// resolution and covers its obstacles inside the ground; with UnknownSpace::kBlocked it covers
/// the whole ground, and unseen space up to 5 m above the ground is in the way.
/// Throws InputError when the file is not such a tree, is corrupt, or all of its obstacles lie
/// outside the ground.
ObstacleMap LoadObstacles(const std::string& file, const HeightMap& ground,
                          const MapPlacement& placement, double floor = 0.3,
                          UnknownSpace unknown_space = UnknownSpace::kFree);

}  // namespace dbd
