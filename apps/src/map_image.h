#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "map_view.h"

namespace dbd {

/// A line on the map, in W.
struct MapLine {
  std::vector<Eigen::Vector2d> points;
  Outcome outcome = Outcome::kReached;
  Eigen::Vector2d end = Eigen::Vector2d::Zero();  ///< where the drive ended
};

/// What a picture shows on top of the ground. Places in W.
struct MapContent {
  std::string title;
  std::string subtitle;
  std::vector<MapLine> candidates;
  std::vector<Eigen::Vector2d> route;  ///< the driven line, empty when there is none
  std::optional<Eigen::Vector2d> start;
  std::optional<Eigen::Vector2d> goal;
  std::optional<Eigen::Vector2d> blocked;
  double obstacle_height = 2;  ///< obstacles that start lower above the ground are shown [m]
};

inline constexpr int kMapImageWidth = 1400;  // [pixels]

/// Height of the strip above the map that holds the title [pixels].
inline constexpr int kMapTitleHeight = 76;

/// Where the ground is in a picture.
struct MapLayout {
  MapView view;
  int top = 0;  ///< rows above the ground's first [pixels]
  int width = 0;
  int height = 0;
};

/// Draws shaded relief, the lines, their ends, a legend with counts, a scale bar and a north arrow
/// into a PNG file. Throws InputError when the file cannot be written.
MapLayout WriteMapImage(const std::filesystem::path& file, const Terrain& terrain,
                        const MapContent& content);

}  // namespace dbd
