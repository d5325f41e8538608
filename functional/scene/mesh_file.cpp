#include "functional/scene/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

constexpr std::array<std::string_view, 7> kExtensions = {".obj", ".ply", ".stl", ".gltf",
                                                         ".glb", ".off", ".3ds"};

void check_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::find(kExtensions, extension) == kExtensions.end()) {
    throw InputError(path.string(), "not a mesh file by its name",
                     ".obj, .ply, .stl, .gltf, .glb, .off or .3ds");
  }
}

void append(const aiMesh& part, const aiMatrix4x4& world_from_node, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D p = world_from_node * part.mVertices[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw InputError(mesh.name, "a coordinate is not finite", "finite numbers");
    }
    mesh.positions.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) {
      continue;  // a point or a line: no surface
    }
    const std::array<std::uint32_t, 3> t{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
    if (std::ranges::max(t) >= part.mNumVertices) {
      throw InputError(mesh.name, "a triangle names a vertex that does not exist",
                       "indices below the number of vertices");
    }
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& world_from_parent,
                 Mesh& mesh) {
  const aiMatrix4x4 world_from_node = world_from_parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    append(*scene.mMeshes[node.mMeshes[i]], world_from_node, mesh);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    append_node(scene, *node.mChildren[i], world_from_node, mesh);
  }
}

void check_indices(const std::filesystem::path& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices != nullptr && face.mIndices[i] < part.mNumVertices) continue;
        throw InputError(path.string(),
                         "face " + std::to_string(f) + " names a vertex it does not have",
                         "indices below " + std::to_string(part.mNumVertices));
      }
    }
  }
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw InputError(path.string(), "no such file", "a mesh file");
  }
  check_extension(path);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  // Post-processing trusts what was read, so a damaged file is found before it.
  if (scene != nullptr) check_indices(path, *scene);
  if (scene != nullptr) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(path.string(), std::string("cannot be read: ") + importer.GetErrorString());
  }
  Mesh mesh;
  mesh.name = path.filename().string();
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
  if (mesh.triangles.empty()) {
    throw InputError(path.string(), "the mesh is empty", "at least one triangle");
  }
  return mesh;
}

}  // namespace wedgesim::functional
