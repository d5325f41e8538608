#include "reports/accuracy/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "functional/scene/manifold.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::reports::accuracy {
namespace {

const View& named(const std::string& name) {
  const auto found = std::ranges::find(built_in_views(), name, &View::name);
  EXPECT_NE(found, built_in_views().end()) << name;
  return *found;
}

const functional::Mesh& caster(const functional::Scene& scene) {
  return std::ranges::find_if(scene.objects, &functional::Object::casts)->mesh;
}

TEST(Views, HaveDifferentNamesAndScenesThatExist) {
  std::set<std::string> names;
  for (const View& view : built_in_views()) {
    EXPECT_TRUE(names.insert(view.name).second) << view.name;
    EXPECT_NO_THROW(functional::scene_source(view.scene)) << view.name;
  }
}

TEST(Views, HaveTheTrianglesTheyAreNamedFor) {
  for (const std::size_t triangles : {224U, 960U, 5760U}) {
    const auto scene = named("torus-" + std::to_string(triangles) + " 300x300").load({});
    ASSERT_TRUE(scene.has_value());
    EXPECT_EQ(scene->width, 300);
    EXPECT_EQ(caster(*scene).triangles.size(), triangles);
    EXPECT_TRUE(functional::is_sound(caster(*scene)));
  }
}

TEST(Views, SubdivisionKeepsTheMeshClosedAndItsVolume) {
  View view = named("torus-224 300x300");
  const auto coarse = view.load({});
  view.subdivide = 2;
  const auto fine = view.load({});
  EXPECT_EQ(caster(*fine).triangles.size(), 16U * 224U);
  EXPECT_TRUE(functional::is_sound(caster(*fine)));
  EXPECT_NEAR(functional::signed_volume(caster(*fine)), functional::signed_volume(caster(*coarse)),
              1e-9);
}

TEST(Views, AFarLightIsSeenUnderTheSameAngles) {
  View view = named("big-light-box-far-disk");
  EXPECT_EQ(view.light_away, 8.0);
  const functional::Light far = view.load({})->light;
  view.light_away = 1.0;
  const functional::Light near = view.load({})->light;
  EXPECT_EQ(far.centre, 8.0 * near.centre);
  EXPECT_EQ(far.radius, 8.0 * near.radius);
  EXPECT_GT(near.radius, 1.0);
}

TEST(Views, WithoutItsMeshAViewIsLeftOut) {
  EXPECT_FALSE(named("cow 512x512").load("/nowhere").has_value());
}

TEST(ParseViews, SaysWhereAndWhatIsWrong) {
  const auto error_of = [](const std::string& line) {
    return input_error_of(
        [&] { parse_views("[[view]]\nname = \"a\"\nscene = \"mesh\"\n" + line, "v.toml"); });
  };
  EXPECT_EQ(error_of("size = \"10\""), "v.toml:4: 'size' is '10'; expected WIDTHxHEIGHT in pixels");
  EXPECT_EQ(error_of("light = \"lamp\""), "v.toml:4: 'light' is 'lamp'; expected rect or sphere");
  EXPECT_NE(error_of("other = 1").find("v.toml:4"), std::string::npos);
}

}  // namespace
}  // namespace wedgesim::reports::accuracy
