#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/image.h"
#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

struct Render : testing::Test {
  TemporaryFolder folder;
  std::string image(const std::string& name) const { return (folder / name).string(); }
  Outcome render(const std::string& scene, const std::string& name,
                 const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"render", scene, "-o", image(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
};

TEST_F(Render, WritesAnImageOfTheAskedSizeByEveryMethod) {
  for (const std::string method : {"coverage", "linear", "hard", "reference"}) {
    expect_good(render("plain-columns", method + ".png",
                       {"--method", method, "--size", "60x40", "--samples", "16"}));
    const Image pixels = read_image(image(method + ".png"));
    EXPECT_EQ(pixels.width, 60);
    EXPECT_EQ(pixels.height, 40);
    EXPECT_EQ(pixels.channels, 3);
    const auto [low, high] = std::ranges::minmax(pixels.values);
    EXPECT_GT(high - low, 0.3F) << method;
  }
}

TEST_F(Render, HardShadowsHaveNoPenumbra) {
  expect_good(
      render("plain-columns", "hard.exr", {"--method", "hard", "--size", "96x64", "--visibility"}));
  expect_good(render("plain-columns", "soft.exr", {"--size", "96x64", "--visibility"}));
  const auto penumbra = [this](const std::string& name) {
    return std::ranges::count_if(read_image(image(name)).values,
                                 [](float v) { return v > 0.01F && v < 0.99F; });
  };
  EXPECT_EQ(penumbra("hard.exr"), 0);
  EXPECT_GT(penumbra("soft.exr"), 50);
}

TEST_F(Render, VisibilityAgreesWithTheReference) {
  expect_good(render("ground-polygon", "c.exr", {"--size", "96x64", "--visibility"}));
  expect_good(render("ground-polygon", "r.exr",
                     {"--size", "96x64", "--visibility", "--method", "reference"}));
  const Image coverage = read_image(image("c.exr"));
  const Image reference = read_image(image("r.exr"));
  ASSERT_EQ(coverage.channels, 1);
  double sum = 0.0;
  for (std::size_t i = 0; i < coverage.values.size(); ++i) {
    const double error = std::clamp(coverage.values[i], 0.0F, 1.0F) - reference.values[i];
    sum += error * error;
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(coverage.values.size())), 0.01);
}

TEST_F(Render, FramesDiffer) {
  expect_good(render("plain-columns", "0.png", {"--size", "48x32"}));
  expect_good(render("plain-columns", "9.png", {"--size", "48x32", "--frame", "9"}));
  EXPECT_NE(read_text(image("0.png")), read_text(image("9.png")));
}

TEST_F(Render, TheLightMayBecomeASphere) {
  expect_good(render("plain-columns", "r.exr", {"--size", "48x32", "--visibility"}));
  expect_good(
      render("plain-columns", "s.exr", {"--size", "48x32", "--visibility", "--light", "sphere"}));
  EXPECT_NE(read_text(image("r.exr")), read_text(image("s.exr")));
}

TEST_F(Render, AllLightsShineUnlessOneIsChosen) {
  const std::vector<std::string> size{"--size", "48x32"};
  const auto brightness = [&](std::vector<std::string> options) {
    options.insert(options.end(), size.begin(), size.end());
    expect_good(render("two-lights", "x.exr", options));
    const Image pixels = read_image(image("x.exr"));
    return std::accumulate(pixels.values.begin(), pixels.values.end(), 0.0);
  };
  const double both = brightness({});
  const double first = brightness({"--light-number", "1"});
  const double second = brightness({"--light-number", "2"});
  EXPECT_GT(both, 1.1 * first);
  EXPECT_GT(both, 1.1 * second);
  EXPECT_NE(first, second);
  EXPECT_EQ(brightness({"--visibility"}), brightness({"--visibility", "--light-number", "1"}));
  EXPECT_NE(brightness({"--visibility"}), brightness({"--visibility", "--light-number", "2"}));
  expect_bad_input(render("two-lights", "x.png", {"--light-number", "3"}), {"--light-number"});
}

TEST_F(Render, ATexturedLightHasThreeColours) {
  const std::vector<std::string> size{"--size", "48x32"};
  const auto pixels = [&](std::vector<std::string> options) {
    options.insert(options.end(), size.begin(), size.end());
    expect_good(render("fire", "x.exr", options));
    return read_image(image("x.exr"));
  };
  EXPECT_EQ(pixels({"--method", "ssv", "--visibility"}).channels, 3);
  const Image first = pixels({"--method", "ssv"});
  EXPECT_NE(pixels({"--method", "ssv", "--frame", "1"}).values, first.values);
  expect_bad_input(render("fire", "y.exr"), {"fire.toml", "has a texture", "coverage", "ssv"});
}

TEST_F(Render, BadOptionsAreRefusedAndNothingIsWritten) {
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> bad{
      {{"--size", "0x0"}, {"--size", "'0x0'", "WIDTHxHEIGHT"}},
      {{"--size", "-4x4"}, {"--size", "-4x4"}},
      {{"--size", "640"}, {"--size", "640"}},
      {{"--size", "99999999999x2"}, {"--size", "16384"}},
      {{"--size", "20000x20000"}, {"--size", "16384"}},
      {{"--size", "12x34x56"}, {"--size"}},
      {{"--frame", "9999"}, {"--frame", "no frame 9999"}},
      {{"--frame", "-1"}, {"--frame", "-1"}},
      {{"--frame", "1.5"}, {"--frame", "1.5"}},
      {{"--method", "guess"}, {"--method", "guess", "hard, sampled, raytraced"}},
      {{"--samples", "0"}, {"--samples", "0"}},
      {{"--light", "tube"}, {"--light", "tube", "rect, sphere"}},
      {{"--mesh", "/nowhere/x.obj"}, {"/nowhere/x.obj"}},
  };
  for (const auto& [options, words] : bad) {
    const std::string scene = options.front() == "--mesh" ? "mesh" : "cylinder";
    expect_bad_input(render(scene, "x.png", options), words);
    EXPECT_EQ(folder.entries(), 0U) << options.back();
  }
}

TEST_F(Render, BadScenesAreRefused) {
  expect_bad_input(render("nowhere", "x.png"), {"nowhere", "no such scene", "columns"});
  expect_bad_input(render(image("missing.toml"), "x.png"), {"missing.toml"});
  write_text(folder / "bad.toml", "description = \"x\"\n[camera]\nspeed = 3\n");
  expect_bad_input(render(image("bad.toml"), "x.png"), {"bad.toml"});
  EXPECT_EQ(folder.entries(), 1U);
  std::filesystem::create_directory(folder / "folder.toml");
  expect_bad_input(render(image("folder.toml"), "x.png"), {"folder.toml", "is a folder"});
  expect_bad_input(render(image("folder.toml/"), "x.png"), {"folder.toml/", "is a folder"});
  expect_bad_input(render("mesh", "x.png", {"--mesh", image("folder.toml")}),
                   {"folder.toml", "is a folder", "a mesh file"});
}

TEST_F(Render, BadPlacesAreRefusedAndNothingIsLeft) {
  const std::vector<std::string> size{"--size", "16x16"};
  expect_bad_input(render("cylinder", "x.jpg", size), {"x.jpg", ".png or .exr"});
  expect_bad_input(render("cylinder", "x", size), {".png or .exr"});
  EXPECT_EQ(folder.entries(), 0U);
  write_text(folder / "file", "");
  expect_bad_input(render("cylinder", "file/x.png", size), {"file/x.png"});
  expect_bad_input(run_command({"render", "cylinder", "-o", "/proc/x.png", "--size", "16x16"}),
                   {"/proc/x.png"});
  std::filesystem::create_directory(folder / "folder.png");
  expect_bad_input(render("cylinder", "folder.png", size), {"folder.png", "is a folder"});
  EXPECT_EQ(folder.entries(), 2U);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "folder.png"));
}

TEST_F(Render, AMeshWithoutAreaIsRefused) {
  write_text(folder / "wire.obj",
             "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  expect_bad_input(render("mesh", "x.png", {"--mesh", image("wire.obj")}),
                   {"wire.obj", "has no area"});
}

TEST_F(Render, AnOpenMeshIsRefusedAndRepairedOnDemand) {
  // A box without its lid: its hole is planar.
  write_text(folder / "open.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
             "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const std::vector<std::string> options{"--mesh", image("open.obj"), "--size", "32x32"};
  expect_bad_input(render("mesh", "x.png", options), {"4 boundary"});
  EXPECT_EQ(folder.entries(), 1U);
  std::vector<std::string> repairing = options;
  repairing.emplace_back("--repair");
  const Outcome repaired = render("mesh", "x.png", repairing);
  EXPECT_EQ(repaired.code, 0);
  EXPECT_NE(repaired.err, "") << "a repair is never silent";
  EXPECT_TRUE(std::filesystem::exists(folder / "x.png"));
}

}  // namespace
}  // namespace wedgesim::cli
