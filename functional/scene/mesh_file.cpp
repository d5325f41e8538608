#include "functional/scene/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <string_view>

#include "base/error.h"
#include "functional/scene/off_indices.h"

namespace wedgesim::functional {
namespace {

constexpr std::array<std::string_view, 7> kExtensions = {".obj", ".ply", ".stl", ".gltf",
                                                         ".glb", ".off", ".3ds"};

std::string checked_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::find(kExtensions, extension) == kExtensions.end()) {
    throw InputError(path.string(), "not a mesh file by its name",
                     ".obj, .ply, .stl, .gltf, .glb, .off or .3ds");
  }
  return extension;
}

// Assimp reads a header without an end for ever.
void check_ply_header(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("end_header")) return;
  }
  throw InputError(path.string(), "its header has no end", "a line end_header");
}

void append(const aiMesh& part, const aiMatrix4x4& world_from_node, const std::string& place,
            Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      throw InputError(place, fmt::format("vertex {} is ({:g}, {:g}, {:g})", i, v.x, v.y, v.z),
                       "finite numbers");
    }
    const aiVector3D p = world_from_node * v;
    mesh.positions.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) {
      continue;  // a point or a line: no surface
    }
    mesh.triangles.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& world_from_parent,
                 const std::string& place, Mesh& mesh) {
  const aiMatrix4x4 world_from_node = world_from_parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    append(*scene.mMeshes[node.mMeshes[i]], world_from_node, place, mesh);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    append_node(scene, *node.mChildren[i], world_from_node, place, mesh);
  }
}

void check_indices(const std::filesystem::path& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      // A face that the file declares and does not hold.
      if (face.mNumIndices == 0 || face.mIndices == nullptr) {
        throw InputError(path.string(), fmt::format("face {}: is missing", f),
                         "every face that the file declares");
      }
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices[i] >= part.mNumVertices) {
          refuse_index(path.string(), f, face.mIndices[i], part.mNumVertices);
        }
      }
    }
  }
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(path.string(), "is a folder", "a mesh file");
  }
  if (!std::filesystem::is_regular_file(path, ignored)) {
    throw InputError(path.string(), "no such file", "a mesh file");
  }
  const std::string extension = checked_extension(path);
  if (extension == ".off") check_off_indices(path);
  if (extension == ".ply") check_ply_header(path);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  // Post-processing trusts what was read, so a damaged file is found before it.
  if (scene != nullptr) check_indices(path, *scene);
  if (scene != nullptr) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(path.string(), std::string("cannot be read: ") + importer.GetErrorString(),
                     "a whole mesh file of this format");
  }
  Mesh mesh;
  mesh.name = path.filename().string();
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), path.string(), mesh);
  if (mesh.triangles.empty()) {
    throw InputError(path.string(), "the mesh is empty", "at least one triangle");
  }
  return mesh;
}

}  // namespace wedgesim::functional
