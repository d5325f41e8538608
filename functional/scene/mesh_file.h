#pragma once

#include <filesystem>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Reads the triangles of a mesh file: OBJ, PLY, STL, glTF (.gltf, .glb), OFF or 3DS. All nodes are
/// joined, each with its transform; polygons are triangulated, points and lines left out. Vertices
/// are as the file has them, not welded; coordinates have single precision. Named after the file.
/// \throws InputError if the file is missing, unreadable, of another format, without triangles or
///         with coordinates that are not finite
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace wedgesim::functional
