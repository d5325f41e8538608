#include "functional/scene/scene_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <glm/common.hpp>

#include "functional/scene/manifold.h"
#include "functional/scene/transform.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

constexpr const char* kScene = R"(description = "test"
size = [32, 16]
[camera]
interpolation = "linear"
key = [
  {eye = [0, 2, 8], target = [0, 1, 0], frames = 10},
  {eye = [5, 2, 8], target = [0, 1, 0]},
]
[light]
centre = [0, 9, 1]
target = [0, 0, 0]
size = [1, 1]
[[object]]
shape = "plane"
size = [10, 10]
[[object]]
shape = "box"
casts = true
size = [1, 1, 1]
)";

constexpr const char* kOpenBox =
    "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nv 0 1 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

class SceneFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  /// The scene above with `from` replaced by `to`.
  std::string edited(const std::string& from, const std::string& to) const {
    std::string text = kScene;
    text.replace(text.find(from), from.size(), to);
    return write("edited.toml", text);
  }
  /// What loading says, without the folder's name.
  std::string error(const std::string& file, const SceneOptions& options = {}) const {
    std::string text = input_error_of([&] { load_scene(file, options); });
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
    return text;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SceneFile, ReadsAScene) {
  const Scene scene = load_scene(write("small.toml", kScene));
  EXPECT_EQ(scene.name, "small");
  EXPECT_EQ(scene.width, 32);
  EXPECT_EQ(scene.height, 16);
  EXPECT_EQ(scene.frames, 11);
  EXPECT_EQ(scene.camera.eye, glm::dvec3(0, 2, 8));
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_FALSE(scene.objects[0].casts);
  EXPECT_TRUE(scene.objects[1].casts);
  EXPECT_EQ(scene.objects[1].mesh.name, "box");
}

TEST_F(SceneFile, KnowsTheFilesItWasReadFrom) {
  const std::string file = write("small.toml", kScene);
  const Scene scene = load_scene(file);
  EXPECT_EQ(scene.place, file);
  EXPECT_EQ(scene.files, (std::vector<std::filesystem::path>{file}));
  const std::filesystem::path mesh = std::filesystem::path(file).parent_path() / "a.obj";
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string more =
      edited("[[object]]", "[[object]]\nshape = \"mesh\"\nfile = \"a.obj\"\n[[object]]");
  EXPECT_EQ(load_scene(more).files, (std::vector<std::filesystem::path>{more, mesh}));
  SceneOptions options;
  options.mesh = write("b.obj",
                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                       "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  EXPECT_EQ(load_scene("mesh", options).files, (std::vector<std::filesystem::path>{*options.mesh}));
  EXPECT_EQ(load_scene("mesh").place, "mesh.toml");
}

TEST_F(SceneFile, SourcesAreKnownWithoutMeshes) {
  EXPECT_EQ(scene_source("fractal").name, "fractal");
  EXPECT_EQ(scene_source("fractal").frames, 40);
  EXPECT_EQ(scene_source("fractal").width, 640);
  const std::string more =
      edited("[[object]]", "[[object]]\nshape = \"mesh\"\nfile = \"nowhere.obj\"\n[[object]]");
  const SceneSource source = scene_source(more);
  const std::filesystem::path path(more);
  EXPECT_EQ(source.files,
            (std::vector<std::filesystem::path>{path, path.parent_path() / "nowhere.obj"}));
  EXPECT_NE(source.text.find("nowhere.obj"), std::string::npos);
  EXPECT_THROW(scene_source(write("odd.toml", "no scene")), InputError);
  EXPECT_THROW(scene_source("nowhere"), InputError);
  EXPECT_THROW(scene_source("/nowhere/x.toml"), InputError);
}

TEST_F(SceneFile, AFieldIsCopiesOverASquare) {
  EXPECT_EQ(load_scene("boxes").objects.size(), 1U + 16U);
  EXPECT_TRUE(scene_source("boxes").has_field);
  EXPECT_FALSE(scene_source("fractal").has_field);
  SceneOptions options;
  options.field_side = 2;
  const Scene scene = load_scene("boxes", options);
  ASSERT_EQ(scene.objects.size(), 1U + 4U);
  const auto extent = [](const Object& object) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::dvec3& position : object.mesh.positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    return std::pair(low, high);
  };
  const auto [low, high] = extent(scene.objects[1]);
  EXPECT_NEAR(high.y - low.y, 2.0, 1e-12) << "half as high as one alone";
  EXPECT_NEAR(0.5 * (low.x + high.x), -2.25, 1e-12);
  EXPECT_NEAR(extent(scene.objects[4]).first.z - low.z, 4.5, 1e-12);
}

TEST_F(SceneFile, LightsAreScaled) {
  SceneOptions options;
  options.light_scale = 2.0;
  const Light light = load_scene("plain-columns").light;
  const Light larger = load_scene("plain-columns", options).light;
  EXPECT_EQ(larger.half_u, 2.0 * light.half_u);
  EXPECT_EQ(larger.half_v, 2.0 * light.half_v);
  EXPECT_EQ(larger.centre, light.centre);
  options.light_shape = LightShape::sphere;
  const double radius = load_scene("plain-columns", options).light.radius;
  options.light_scale = 1.0;
  EXPECT_EQ(radius, 2.0 * load_scene("plain-columns", options).light.radius);
}

constexpr const char* kLight = "[light]\ncentre = [0, 9, 1]\ntarget = [0, 0, 0]\nsize = [1, 1]\n";
constexpr const char* kTwoLights =
    "[[light]]\ncentre = [0, 9, 1]\ntarget = [0, 0, 0]\nsize = [1, 1]\n"
    "[[light]]\ncentre = [4, 7, 1]\nshape = \"sphere\"\nradius = 0.5\n";

TEST_F(SceneFile, SeveralLightsAreTables) {
  EXPECT_TRUE(load_scene(write("small.toml", kScene)).other_lights.empty());
  const std::string file = edited(kLight, kTwoLights);
  const Scene scene = load_scene(file);
  EXPECT_EQ(scene.light.centre, glm::dvec3(0, 9, 1));
  ASSERT_EQ(scene.other_lights.size(), 1U);
  EXPECT_EQ(scene.other_lights[0].centre, glm::dvec3(4, 7, 1));
  EXPECT_EQ(scene.other_lights[0].radius, 0.5);
  SceneOptions options;
  options.light_scale = 2.0;
  EXPECT_EQ(load_scene(file, options).other_lights[0].radius, 1.0);
  options.light_shape = LightShape::rectangle;
  EXPECT_EQ(load_scene(file, options).other_lights[0].shape, LightShape::rectangle);
}

TEST_F(SceneFile, EveryLightIsChecked) {
  std::string inside = kTwoLights;
  inside.replace(inside.find("[4, 7, 1]"), 9, "[0, 1, 0]");
  EXPECT_EQ(error(edited(kLight, inside)),
            "edited.toml: the light touches 'box'; expected a light clear of all geometry");
  std::string odd = kTwoLights;
  odd.replace(odd.find("radius"), 6, "redius");
  EXPECT_EQ(error(edited(kLight, odd)), "edited.toml:13: 'radius' is missing; expected a number");
  EXPECT_EQ(error(write("none.toml",
                        "description = \"x\"\nlight = []\n[camera]\neye = [0, 2, 8]\n"
                        "target = [0, 1, 0]\n")),
            "none.toml:2: 'light' is not an array of tables; expected tables [[light]]");
}

TEST_F(SceneFile, FoldersAreNoScenes) {
  const std::string folder = std::filesystem::path(write("a", "")).parent_path().string();
  EXPECT_EQ(error(folder), folder + ": is a folder; expected a scene file");
  EXPECT_EQ(error(folder + "/"), ": is a folder; expected a scene file");
}

TEST_F(SceneFile, CoordinatesHaveARange) {
  EXPECT_EQ(error(edited("size = [1, 1, 1]",
                         "size = [1, 1, 1]\nscale = [1, 1, 1e12]\n"
                         "position = [0, 0, 6e11]")),
            "edited.toml: mesh 'box': vertex 0 is at (-0.5, 0, 1.1e+12); expected numbers from "
            "-1e+12 to 1e+12");
}

TEST_F(SceneFile, OptionsChangeSizeFrameAndLight) {
  SceneOptions options;
  options.size = {64, 48};
  options.frame = 4;
  options.light_shape = LightShape::sphere;
  const Scene scene = load_scene(write("small.toml", kScene), options);
  EXPECT_EQ(scene.width, 64);
  EXPECT_EQ(scene.height, 48);
  EXPECT_EQ(scene.frame, 4);
  EXPECT_EQ(scene.camera.eye, glm::dvec3(2, 2, 8));
  EXPECT_EQ(scene.light.shape, LightShape::sphere);
  EXPECT_DOUBLE_EQ(scene.light.radius, 0.5);
}

TEST_F(SceneFile, BadOptionsAreNamed) {
  const std::string file = write("small.toml", kScene);
  SceneOptions options;
  options.frame = 11;
  EXPECT_EQ(error(file, options), "--frame: small has no frame 11; expected 0 to 10");
  options.frame = -1;
  EXPECT_EQ(error(file, options), "--frame: small has no frame -1; expected 0 to 10");
  options = {};
  options.size = {0, 5};
  EXPECT_EQ(error(file, options), "--size: 0x5; expected 1 to 16384 pixels each way");
  options.size = {5, 16385};
  EXPECT_EQ(error(file, options), "--size: 5x16385; expected 1 to 16384 pixels each way");
  options = {};
  options.mesh = write("a.obj", kOpenBox);
  EXPECT_EQ(error(file, options),
            "--mesh: small has no place for a mesh; expected the scene 'mesh', or an object with "
            "shape = \"user\"");
}

TEST_F(SceneFile, MistakesInTheFileHaveTheirLine) {
  EXPECT_EQ(error(edited("size = [32, 16]", "sise = [32, 16]")),
            "edited.toml:2: unknown key 'sise'; expected one of description, size, camera, light, "
            "object");
  EXPECT_EQ(error(edited("size = [32, 16]", "size = [32.5, 16]")),
            "edited.toml:2: 'size' is not whole; expected pixels [width, height]");
  EXPECT_EQ(error(edited("size = [32, 16]", "size = [0, 16]")),
            "edited.toml:2: 'size' is 0; expected a number from 1 to 16384");
  EXPECT_EQ(error(edited("interpolation = \"linear\"", "interpolation = \"cubic\"")),
            "edited.toml:4: 'interpolation' is 'cubic'; expected linear or catmull-rom");
  EXPECT_EQ(error(edited("interpolation = \"linear\"", "near = 2\nfar = 1")),
            "edited.toml:5: 'far' is not beyond 'near'; expected near < far");
  EXPECT_EQ(error(edited("target = [0, 1, 0], frames = 10", "target = [0, -1, 8], frames = 10")),
            "edited.toml:3: the camera has no direction, or looks along 'up'; expected eye, target "
            "and up that span a plane");
  EXPECT_EQ(error(edited("frames = 10}", "frames = 10, speed = 1}")),
            "edited.toml:6: unknown key 'speed'; expected one of eye, target, frames");
  EXPECT_EQ(error(edited("shape = \"box\"", "shape = \"cube\"")).substr(0, 41),
            "edited.toml:17: 'shape' is 'cube'; expect");
  EXPECT_EQ(error(edited("size = [1, 1, 1]", "size = [1, 0, 1]")),
            "edited.toml:19: 'size' is 0; expected a number from 1e-12 to 1e+12");
  EXPECT_EQ(error(edited("size = [1, 1, 1]", "size = [1, 1, 1]\nradius = 2")),
            "edited.toml:20: unknown key 'radius'; expected one of casts, colour, repair, shape, "
            "size, name, fit, scale, turn, field, positions, position");
  EXPECT_EQ(error(edited("centre = [0, 9, 1]", "centre = [0, nan, 1]")),
            "edited.toml:10: 'centre' is nan; expected a finite number");
  EXPECT_EQ(error(edited("size = [1, 1, 1]", "size = [1, 1, 1]\ncolour = [2, 0, 0]")),
            "edited.toml:20: 'colour' is 2; expected a number from 0 to 1");
}

TEST_F(SceneFile, MissingScenesAreNamed) {
  EXPECT_EQ(error("/nowhere/a.toml"),
            "/nowhere/a.toml: No such file or directory; expected a readable file");
  EXPECT_EQ(error("no-such-scene").substr(0, 42), "no-such-scene: no such scene; expected big");
}

TEST_F(SceneFile, LightsInTheWrongPlaceAreNamed) {
  EXPECT_EQ(error(edited("centre = [0, 9, 1]", "centre = [0, 0.5, 0.1]")),
            "edited.toml: the light touches 'box'; expected a light clear of all geometry");
  const std::string inside = edited("centre = [0, 9, 1]", "centre = [0, 0.5, 0.1]");
  SceneOptions point;
  point.light_shape = LightShape::point;
  EXPECT_EQ(error(inside, point),
            "edited.toml: the light is inside 'box'; expected a light clear of all geometry");
  EXPECT_EQ(error(edited("centre = [0, 9, 1]", "centre = [3, 0, 0]"), point),
            "edited.toml: the light touches 'plane'; expected a light clear of all geometry");
  EXPECT_EQ(error(edited("target = [0, 0, 0]", "target = [0, 20, 0]")),
            "edited.toml: caster 'box' is not in front of the light: (-0.5, 0, 0.5); expected "
            "casters strictly in front of the light's plane");
}

TEST_F(SceneFile, PositionsMakeCopies) {
  const Scene scene =
      load_scene(edited("size = [1, 1, 1]",
                        "size = [1, 1, 1]\npositions = [[0, 0, 0], [3, 0, 0]]\nturn = [0, 90, 0]"));
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(scene.objects[2].mesh.name, "box 2");
  EXPECT_EQ(bounds_of(scene.objects[2].mesh).first, glm::dvec3(2.5, 0.0, -0.5));
}

TEST_F(SceneFile, OpenCasterIsRefusedAndRepairedOnlyOnDemand) {
  write("open.obj", kOpenBox);
  const std::string text = "shape = \"mesh\"\nfile = \"open.obj\"\n";
  const std::string box = "shape = \"box\"\n";
  const std::string size = "size = [1, 1, 1]";
  std::string scene = kScene;
  scene.replace(scene.find(box), box.size(), text);
  scene.erase(scene.find(size), size.size());
  const std::string file = write("caster.toml", scene);
  EXPECT_EQ(error(file),
            "caster.toml:16: mesh 'open.obj' is not closed: 4 boundary, 0 non-manifold and 0 "
            "inconsistently oriented edges, the first at (0.5, 0, 0); expected a closed "
            "two-manifold");
  SceneOptions options;
  options.repair = true;
  std::vector<std::string> notes;
  const Scene repaired = load_scene(file, options, &notes);
  EXPECT_TRUE(is_sound(repaired.objects[1].mesh));
  EXPECT_EQ(notes, std::vector<std::string>{
                       "repair of 'open.obj': closed 1 planar holes with 2 triangles"});
  EXPECT_NO_THROW(load_scene(write("own.toml", scene + "repair = true\n")));
}

TEST_F(SceneFile, RepairThatDoesNotSufficeSaysSo) {
  SceneOptions options;
  options.repair = true;
  options.mesh = write("fin.obj", std::string(kOpenBox) + "v 3 3 3\nf 2 5 6\n");
  EXPECT_EQ(error("mesh", options).substr(0, 70),
            "fin.obj: mesh 'fin.obj' is not closed even after repair: 2 boundary, 1");
}

TEST_F(SceneFile, UserMeshIsFittedOverTheFloor) {
  SceneOptions options;
  options.mesh = write("big.obj",
                       "v 0 0 0\nv 100 0 0\nv 0 0 -100\nv 0 100 0\n"
                       "f 3 2 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Scene scene = load_scene("mesh", options);
  const auto [low, high] = bounds_of(scene.objects.back().mesh);
  EXPECT_NEAR(high.x - low.x, 2.6, 1e-9);
  EXPECT_GT(low.y, 0.0);
}

}  // namespace
}  // namespace wedgesim::functional
