#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dbd {

/// Delaunay triangulation of points seen from above. Throws InputError with `name` when they do
/// not span an area.
std::vector<std::array<std::uint32_t, 3>> Triangulate(const std::string& name,
                                                      const std::vector<Eigen::Vector3d>& points);

}  // namespace dbd
