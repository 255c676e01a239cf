#include <filesystem>
#include <utility>

#include "file_formats.h"
#include "mesh_file.h"

namespace dbd {

FileInfo DescribeMeshFile(const std::string& file) {
  const TriangleMesh mesh = ReadMesh(file);
  FileInfo info;
  info.format = std::filesystem::path(file).extension() == ".obj" ? "OBJ" : "PLY";
  MeshFileInfo content;
  content.vertices = mesh.vertices.size();
  content.triangles = mesh.triangles.size();
  for (const Eigen::Vector3d& vertex : mesh.vertices) content.extent.Add(vertex);
  info.content = std::move(content);
  return info;
}

}  // namespace dbd
