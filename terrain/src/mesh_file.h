#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dbd {

/// Triangles over shared vertices, as a file holds them.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into `vertices`
};

/// Reads a PLY or OBJ file; polygons are cut into triangles and equal vertices joined. Coordinates
/// are read as float, so a mesh far from its origin (beyond 100 km) is refused.
/// Throws InputError that names the file and what is wrong with it.
TriangleMesh ReadMesh(const std::string& file);

}  // namespace dbd
