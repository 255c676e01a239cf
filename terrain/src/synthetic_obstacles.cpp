#include "synthetic_obstacles.h"

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

enum Channel { kPlaceX = 100, kPlaceY, kGrows, kSize, kKind, kGroves = 110 };

constexpr double kResolution = 0.5;    // [m]
constexpr double kRockShare = 0.1;     // of all obstacles [-]
constexpr double kFreeRadius = 10.0;   // round start and goal [m]
constexpr double kGroveLength = 60.0;  // [m]

class Builder {
 public:
  Builder(const HeightMap& ground, octomap::OcTree* tree) : ground_(ground), tree_(*tree) {}

  // `size` in [0, 1).
  void AddTree(const Eigen::Vector2d& place, double size) {
    const double height = 5 + 7 * size;
    const double crown_radius = 1.2 + 1.3 * size;
    const double foot = ground_.Height(place.x(), place.y());
    const Eigen::Vector3d crown(place.x(), place.y(), foot + height - crown_radius);
    for (double z = foot; z < crown.z(); z += kResolution) Fill({place.x(), place.y(), z});
    const int reach = static_cast<int>(crown_radius / kResolution);
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        for (int k = -reach; k <= reach; ++k) {
          const Eigen::Vector3d offset = kResolution * Eigen::Vector3d(i, j, k);
          if (offset.norm() <= crown_radius) Fill(crown + offset);
        }
      }
    }
  }

  void AddRock(const Eigen::Vector2d& place, double size) {
    const int width = 2 + static_cast<int>(3 * size);
    const int height = 2 + static_cast<int>(2 * size);
    const double foot = ground_.Height(place.x(), place.y());
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < width; ++j) {
        for (int k = -1; k < height; ++k) {
          Fill(Eigen::Vector3d(place.x(), place.y(), foot) +
               kResolution * Eigen::Vector3d(i, j, k));
        }
      }
    }
  }

 private:
  void Fill(const Eigen::Vector3d& place) {
    tree_.updateNode(place.x(), place.y(), place.z(), true, true);
  }

  const HeightMap& ground_;
  octomap::OcTree& tree_;
};

bool IsFree(const Eigen::Vector2d& place, const SyntheticLandscape& landscape,
            const std::vector<Eigen::Vector2d>& keep_free) {
  const double brook = landscape.brook_half_width() + 3;
  const double trench = landscape.trench_outer_radius();
  if (landscape.BrookDistance(place) < brook) return false;
  if (trench > 0 && (place - landscape.center()).norm() < trench + 5) return false;
  return std::all_of(keep_free.begin(), keep_free.end(), [&place](const Eigen::Vector2d& kept) {
    return (place - kept).norm() > kFreeRadius;
  });
}

}  // namespace

// One place is tried in each square of a lattice that has two squares per tree; a square's chance
// is one half on average and more inside a grove.
std::unique_ptr<octomap::OcTree> MakeObstacles(const GeneratorOptions& options,
                                               const SyntheticLandscape& landscape,
                                               const std::vector<Eigen::Vector2d>& keep_free) {
  auto tree = std::make_unique<octomap::OcTree>(kResolution);
  if (options.tree_density <= 0) return tree;
  const HashNoise noise(options.seed);
  Builder builder(landscape.heights(), tree.get());
  const double side = std::sqrt(1e4 / (2 * options.tree_density));
  const double margin = 3.0;
  const double usable = options.size * options.cell_size - 2 * margin;
  const int squares = static_cast<int>(usable / side);
  for (int i = 0; i < squares; ++i) {
    for (int j = 0; j < squares; ++j) {
      const Eigen::Vector2d in_square(noise.Uniform(i, j, kPlaceX), noise.Uniform(i, j, kPlaceY));
      const Eigen::Vector2d place =
          Eigen::Vector2d::Constant(margin) + (Eigen::Vector2d(i, j) + in_square) * side;
      const Eigen::Vector2d scaled = place / kGroveLength;
      const double chance = 0.5 + 1.2 * noise.Gradient(scaled.x(), scaled.y(), kGroves);
      if (noise.Uniform(i, j, kGrows) >= chance || !IsFree(place, landscape, keep_free)) continue;
      const double size = noise.Uniform(i, j, kSize);
      if (noise.Uniform(i, j, kKind) < kRockShare) {
        builder.AddRock(place, size);
      } else {
        builder.AddTree(place, size);
      }
    }
  }
  tree->updateInnerOccupancy();
  return tree;
}

}  // namespace dbd
