#include "mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dbd/core/error.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>

namespace dbd {
namespace {

// A float keeps centimetres up to here [m].
constexpr double kFarthest = 100e3;

constexpr double kLargestFileBytes = 1e9;

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

void CheckFile(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) Fail(file, "no such file");
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  if (error) Fail(file, error.message());
  if (bytes > kLargestFileBytes) Fail(file, "is larger than 1 GB; rasterise it first");
}

void AddVertices(const std::string& file, const aiMesh& part, TriangleMesh* mesh) {
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    const Eigen::Vector3d vertex(v.x, v.y, v.z);
    if (!vertex.allFinite()) Fail(file, "is corrupt: a vertex is not finite");
    if (vertex.cwiseAbs().maxCoeff() > kFarthest) {
      Fail(file,
           "lies more than 100 km from its origin, too far for meshes in float; move its "
           "origin and give it with --dem-origin");
    }
    mesh->vertices.push_back(vertex);
  }
}

void AddTriangles(const std::string& file, const aiMesh& part, std::uint32_t first,
                  TriangleMesh* mesh) {
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // a point or an edge
    for (int k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= part.mNumVertices) Fail(file, "is corrupt: a face has no vertex");
    }
    mesh->triangles.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

}  // namespace

TriangleMesh ReadMesh(const std::string& file) {
  CheckFile(file);
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TEXCOORDS | aiComponent_COLORS |
                                  aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_MATERIALS);
  const aiScene* scene = importer.ReadFile(
      file, aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices | aiProcess_Triangulate);
  if (scene == nullptr) {
    Fail(file, "cannot be read as a mesh: " + std::string(importer.GetErrorString()));
  }
  TriangleMesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    AddVertices(file, *scene->mMeshes[i], &mesh);
    AddTriangles(file, *scene->mMeshes[i], first, &mesh);
  }
  if (mesh.triangles.empty()) Fail(file, "holds no triangle");
  return mesh;
}

}  // namespace dbd
