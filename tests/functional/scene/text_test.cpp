#include "functional/scene/text.h"

#include <gtest/gtest.h>

#include "functional/scene/transform.h"
#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

TEST(Text, EulerNumberCountsCounters) {
  // 2 a solid letter, 0 with one counter, -2 with two.
  const std::pair<const char*, long> cases[] = {{"2", 2}, {"0", 0},  {"8", -2}, {"B", -2},
                                                {"i", 4}, {"%", 2},  {"A", 0},  {"2002", 4},
                                                {"&", 0}, {"Qq@", 0}};
  for (const auto& [text, euler] : cases) {
    const Mesh mesh = make_text(text, {});
    EXPECT_GT(sound_volume(mesh), 0.0) << text;
    EXPECT_EQ(euler_number(mesh), euler) << text;
  }
}

TEST(Text, EveryPrintableCharacterIsClosed) {
  for (char c = '!'; c <= '~'; ++c) {
    for (const int segments : {1, 6, 16}) {
      TextStyle style;
      style.curve_segments = segments;
      EXPECT_GT(sound_volume(make_text(std::string(1, c), style)), 0.0) << c << ' ' << segments;
    }
  }
}

TEST(Text, StandsOnTheGroundAsStyled) {
  TextStyle style;
  style.height = 2.0;
  style.depth = 0.5;
  const auto [low, high] = bounds_of(make_text("H2", style));
  EXPECT_DOUBLE_EQ(low.y, 0.0);
  EXPECT_DOUBLE_EQ(high.y, 2.0);
  EXPECT_DOUBLE_EQ(low.z, -0.25);
  EXPECT_DOUBLE_EQ(high.z, 0.25);
  EXPECT_DOUBLE_EQ(low.x, -high.x);
}

TEST(Text, LetterIHasTheVolumeOfABox) {
  TextStyle style;
  style.depth = 0.5;
  const Mesh letter = make_text("I", style);
  const auto [low, high] = bounds_of(letter);
  EXPECT_NEAR(sound_volume(letter), (high.x - low.x) * 1.0 * 0.5, 1e-12);
}

TEST(Text, ReadsAlongX) {
  // "L" is heavier on its left, "J" on its right: seen from +z, text must not be mirrored.
  const auto weight = [](const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
      const glm::dvec3 a = mesh.positions[t[0]];
      const double z = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a).z;
      sum += z > 0.0 ? z * (a.x + mesh.positions[t[1]].x + mesh.positions[t[2]].x) : 0.0;
    }
    return sum;
  };
  EXPECT_LT(weight(make_text("L", {})), 0.0);
  EXPECT_GT(weight(make_text("J", {})), 0.0);
}

TEST(Text, Errors) {
  EXPECT_EQ(input_error_of([] { make_text("  ", {}); }),
            "text: '  ' has no outline; expected letters or digits");
  EXPECT_EQ(
      input_error_of([] { make_text("a\tb", {}); }),
      "text: has a character that is not printable ASCII; expected characters from space to ~");
  TextStyle style;
  style.font = "/nowhere.ttf";
  EXPECT_EQ(input_error_of([&] { make_text("a", style); }),
            "/nowhere.ttf: cannot be read as a font; expected a TrueType font");
}

}  // namespace
}  // namespace wedgesim::functional
