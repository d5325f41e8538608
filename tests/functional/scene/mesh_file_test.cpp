#include "functional/scene/mesh_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

// A pyramid of volume 1/3 over the unit square, its base one quadrilateral.
constexpr const char* kObj = R"(v 0 0 0
v 1 0 0
v 1 0 -1
v 0 0 -1
v 0 1 0
f 4 3 2 1
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
)";
constexpr const char* kPly = R"(ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
element face 5
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 0 -1
0 0 -1
0 1 0
4 3 2 1 0
3 0 1 4
3 1 2 4
3 2 3 4
3 3 0 4
)";
constexpr const char* kOff = R"(OFF
5 5 8
0 0 0
1 0 0
1 0 -1
0 0 -1
0 1 0
4 3 2 1 0
3 0 1 4
3 1 2 4
3 2 3 4
3 3 0 4
)";
constexpr const char* kStl = R"(solid pyramid
facet normal 0 -1 0
outer loop
vertex 0 0 -1
vertex 1 0 -1
vertex 1 0 0
endloop
endfacet
facet normal 0 -1 0
outer loop
vertex 0 0 -1
vertex 1 0 0
vertex 0 0 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
facet normal 1 1 0
outer loop
vertex 1 0 0
vertex 1 0 -1
vertex 0 1 0
endloop
endfacet
facet normal 0 1 -1
outer loop
vertex 1 0 -1
vertex 0 0 -1
vertex 0 1 0
endloop
endfacet
facet normal -1 0 0
outer loop
vertex 0 0 -1
vertex 0 0 0
vertex 0 1 0
endloop
endfacet
endsolid pyramid
)";
// Two nodes share one mesh; the second is moved by (5, 0, 0) below a parent that doubles.
constexpr const char* kGltf =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0}, {"scale": [2, 2, 2], "children": [2]}, {"mesh": 0, "translation": [5, 0, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [
 {"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [0, 0, -1], "max": [1, 1, 0]},
 {"bufferView": 1, "componentType": 5123, "count": 18, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 60},
 {"buffer": 0, "byteOffset": 60, "byteLength": 36}],
"buffers": [{"uri": "pyramid.bin", "byteLength": 96}]})";

class MeshFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string error(const std::filesystem::path& path) {
    return input_error_of([&] { load_mesh(path); });
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(MeshFile, AllFormatsGiveTheSamePyramid) {
  for (const auto& [name, text] : {std::pair{"a.obj", kObj},
                                   {"a.ply", kPly},
                                   {"a.off", kOff},
                                   {"a.stl", kStl},
                                   {"UPPER.OBJ", kObj}}) {
    const Mesh mesh = load_mesh(write(name, text));
    EXPECT_EQ(mesh.name, name);
    EXPECT_EQ(mesh.triangles.size(), 6U) << name;
    EXPECT_EQ(welded(mesh).positions.size(), 5U) << name;
    EXPECT_DOUBLE_EQ(sound_volume(mesh), 1.0 / 3.0) << name;
  }
}

TEST_F(MeshFile, GltfNodesAreJoinedWithTheirTransforms) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1, 0, 1, 0};
  const std::uint16_t indices[] = {3, 2, 1, 3, 1, 0, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  std::string bytes(96, '\0');
  std::memcpy(bytes.data(), positions, 60);
  std::memcpy(bytes.data() + 60, indices, 36);
  write("pyramid.bin", bytes);
  const Mesh mesh = load_mesh(write("two.gltf", kGltf));
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(sound_volume(mesh), (1.0 + 8.0) / 3.0);
  double right = 0.0;
  for (const glm::dvec3& p : mesh.positions) {
    right = std::max(right, p.x);
  }
  EXPECT_DOUBLE_EQ(right, 12.0);
}

TEST_F(MeshFile, PointsThatDifferByOneBitStayApart) {
  const Mesh mesh = load_mesh(write("near.obj",
                                    "v 1 0 0\nv 0 1 0\nv 0 0 0\nv 1.0000001 0 0\n"
                                    "f 1 2 3\nf 4 3 2\n"));
  EXPECT_EQ(welded(mesh).positions.size(), 4U);
}

// The pyramid's triangles without the base's second one, in binary; one index may be another.
std::string binary_ply(std::int32_t last_index) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty float x\n"
      "property float y\nproperty float z\nelement face 5\n"
      "property list uchar int vertex_indices\nend_header\n";
  const auto add = [&text](const auto& value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const float x :
       {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 0.F, -1.F, 0.F, 0.F, -1.F, 0.F, 1.F, 0.F})
    add(x);
  const std::int32_t faces[5][3] = {{3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, last_index}};
  for (const auto& face : faces) {
    add(std::uint8_t{3});
    for (const std::int32_t index : face) add(index);
  }
  return text;
}

TEST_F(MeshFile, ABinaryPlyCutAnywhereNeverCrashes) {
  const std::string whole = binary_ply(4);
  EXPECT_EQ(load_mesh(write("whole.ply", whole)).triangles.size(), 5U);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto path = write("cut.ply", whole.substr(0, length));
    try {
      EXPECT_LE(load_mesh(path).triangles.size(), 5U) << length;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("cut.ply: "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("; expected "), std::string::npos) << error.what();
    }
  }
}

TEST_F(MeshFile, AFaceThatNamesNoVertexIsRefused) {
  for (const std::int32_t index : {5, 1000000000, -1}) {
    const auto ply = write("index.ply", binary_ply(index));
    EXPECT_EQ(error(ply), ply.string() + ": face 4: index " +
                              std::to_string(static_cast<std::uint32_t>(index)) +
                              "; expected 0..4");
  }
}

TEST_F(MeshFile, AVertexThatIsNoNumberIsNamed) {
  const auto nan = write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 3\nf 1 2 3\n");
  EXPECT_EQ(error(nan), nan.string() + ": vertex 2 is (0, nan, 3); expected finite numbers");
}

TEST_F(MeshFile, Errors) {
  EXPECT_EQ(error("/nowhere/a.obj"), "/nowhere/a.obj: no such file; expected a mesh file");
  const std::filesystem::path folder = write("a.obj", "").parent_path();
  EXPECT_EQ(error(folder), folder.string() + ": is a folder; expected a mesh file");
  const auto text = write("a.txt", kObj);
  EXPECT_EQ(error(text), text.string() +
                             ": not a mesh file by its name; expected .obj, .ply, .stl, "
                             ".gltf, .glb, .off or .3ds");
  for (const char* name :
       {"junk.obj", "junk.ply", "junk.stl", "junk.gltf", "junk.glb", "junk.off", "junk.3ds"}) {
    const auto junk = write(name, "no mesh at all\n");
    EXPECT_NE(error(junk).find(junk.string()), std::string::npos) << error(junk);
    EXPECT_NE(error(junk).find("; expected "), std::string::npos) << error(junk);
  }
  const auto empty = write("empty.obj", "");
  EXPECT_NE(error(empty), "");
  const auto points = write("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_NE(error(points), "");
  const auto faces = write("faces.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_NE(error(faces).find("face 1: is missing; expected "), std::string::npos) << error(faces);
  const auto index = write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  EXPECT_NE(error(index), "");
}

}  // namespace
}  // namespace wedgesim::functional
