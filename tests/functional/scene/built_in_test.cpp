#include "functional/scene/built_in.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <set>

#include "functional/scene/lights.h"
#include "functional/scene/manifold.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

const char* const kBunny = "/usr/share/glmark2/models/bunny.obj";

/// Skips what needs a package that is not there.
#define SKIP_WITHOUT_BUNNY(name)                                     \
  if ((name) == "bunny" && !std::filesystem::exists(kBunny)) {       \
    GTEST_SKIP() << kBunny << " of package glmark2-data is missing"; \
  }

class BuiltIn : public ::testing::TestWithParam<SceneInfo> {};

TEST_P(BuiltIn, LoadsAtBothEndsOfItsPath) {
  SKIP_WITHOUT_BUNNY(GetParam().name);
  EXPECT_GE(GetParam().frames, 30);
  EXPECT_FALSE(GetParam().description.empty());
  SceneOptions options;
  options.frame = GetParam().frames - 1;
  const Scene first = load_scene(GetParam().name);
  const Scene last = load_scene(GetParam().name, options);
  EXPECT_EQ(first.width, 640);
  EXPECT_EQ(first.height, 427);
  EXPECT_NE(first.camera.eye, last.camera.eye);
  EXPECT_EQ(first.objects.front().mesh.positions, last.objects.front().mesh.positions);
}

TEST_P(BuiltIn, CastersAreSound) {
  SKIP_WITHOUT_BUNNY(GetParam().name);
  bool casts = false;
  for (const Object& object : load_scene(GetParam().name).objects) {
    casts = casts || object.casts;
    EXPECT_TRUE(!object.casts || is_sound(object.mesh)) << object.mesh.name;
  }
  EXPECT_TRUE(casts);
}

void expect_in_front(const Scene& scene, const Light& light) {
  ASSERT_EQ(light.shape, LightShape::rectangle);
  const glm::dvec3 shine = glm::normalize(glm::cross(light.half_u, light.half_v));
  for (const Object& object : scene.objects) {
    double least_shine = 1e300;
    for (const glm::dvec3& p : object.mesh.positions) {
      least_shine = std::min(least_shine, glm::dot(p - light.centre, shine));
    }
    EXPECT_GT(least_shine, 0.5) << object.mesh.name;
  }
}

TEST_P(BuiltIn, EverythingIsInFrontOfTheLightsAndTheCameraSeesItWhole) {
  SKIP_WITHOUT_BUNNY(GetParam().name);
  for (const int frame : {0, GetParam().frames / 2, GetParam().frames - 1}) {
    SceneOptions options;
    options.frame = frame;
    const Scene scene = load_scene(GetParam().name, options);
    for (std::size_t i = 0; i < light_count(scene); ++i) expect_in_front(scene, light_at(scene, i));
    const Camera& camera = scene.camera;
    const glm::dvec3 view = glm::normalize(camera.target - camera.eye);
    for (const Object& object : scene.objects) {
      double nearest = 1e300;
      double farthest = 0.0;
      for (const glm::dvec3& p : object.mesh.positions) {
        nearest = std::min(nearest, glm::dot(p - camera.eye, view));
        farthest = std::max(farthest, glm::dot(p - camera.eye, view));
      }
      EXPECT_LT(farthest, camera.far_plane) << object.mesh.name << " frame " << frame;
      EXPECT_TRUE(!object.casts || nearest > camera.near_plane)
          << object.mesh.name << " frame " << frame << ": " << nearest;
    }
  }
}

// Whether a caster is between two points.
bool is_dark(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& centre) {
  const glm::dvec3 ray = centre - eye;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const auto& t : object.mesh.triangles) {
      const glm::dvec3 a = object.mesh.positions[t[0]] - eye;
      const glm::dvec3 b = object.mesh.positions[t[1]] - eye;
      const glm::dvec3 c = object.mesh.positions[t[2]] - eye;
      const double u = glm::dot(ray, glm::cross(a, b));
      const double v = glm::dot(ray, glm::cross(b, c));
      const double w = glm::dot(ray, glm::cross(c, a));
      const bool same_side = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
      const double t_hit = glm::dot(a, glm::cross(b, c)) / (u + v + w);
      if (same_side && t_hit > 0.0 && t_hit < 1.0) return true;
    }
  }
  return false;
}

TEST_P(BuiltIn, EyeIsInShadowOnlyWhereTheNameSaysSo) {
  SKIP_WITHOUT_BUNNY(GetParam().name);
  for (int frame = 0; frame < GetParam().frames; frame += 10) {
    SceneOptions options;
    options.frame = frame;
    const Scene scene = load_scene(GetParam().name, options);
    for (std::size_t i = 0; i < light_count(scene); ++i) {
      EXPECT_EQ(is_dark(scene, scene.camera.eye, light_at(scene, i).centre),
                GetParam().name == "eye-in-shadow")
          << "frame " << frame << " light " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltIn, ::testing::ValuesIn(built_in_scenes()),
                         [](const auto& scene) {
                           std::string name = scene.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(BuiltInFiles, AreTheFilesOfTheFolder) {
  std::set<std::string> on_disk;
  for (const auto& entry :
       std::filesystem::directory_iterator(WEDGESIM_SOURCE_DIR "/traces/scenes")) {
    if (entry.path().extension() != ".toml") {
      continue;
    }
    on_disk.insert(entry.path().stem().string());
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    bool found = false;
    for (const BuiltInFile& file : built_in_files()) {
      found = found || (file.name == entry.path().stem().string() && file.text == text);
    }
    EXPECT_TRUE(found) << entry.path();
  }
  EXPECT_EQ(built_in_files().size(), on_disk.size());
  for (const char* name :
       {"plain-columns", "columns", "fractal", "text2002", "spheres27", "big-light-box", "overlap",
        "cylinder", "ground-polygon", "bunny", "eye-in-shadow", "two-lights", "fire", "mesh"}) {
    EXPECT_TRUE(on_disk.contains(name)) << name;
  }
}

TEST(BuiltInFiles, FractalHasTheTrianglesOfThePaper) {
  EXPECT_EQ(load_scene("fractal").objects.front().mesh.triangles.size(), 100352U);
}

TEST(BuiltInFiles, BunnyIsClosedWithoutRepair) {
  SKIP_WITHOUT_BUNNY(std::string("bunny"));
  std::vector<std::string> notes;
  EXPECT_EQ(load_scene("bunny", {}, &notes).objects.back().mesh.triangles.size(), 69666U);
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace wedgesim::functional
