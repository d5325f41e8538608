#include <gtest/gtest.h>

#include "base/image.h"
#include "tests/cli/command.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

// The frame of another renderer: a box of 1 on a floor at y = 0, seen level along -z from
// (0, 1, 5.5); its front is 5 away, the floor by similar triangles.
struct Import : testing::Test {
  static constexpr int kWidth = 32;
  static constexpr int kHeight = 32;
  TemporaryFolder folder;
  std::filesystem::path scene = folder / "frame.toml";
  std::filesystem::path image = folder / "frame.exr";
  std::filesystem::path file = folder / "frame.wtrace";

  Import() {
    // An x and y of 1/w times 2: 53.13 degrees. The last row: w = -(z - 5.5).
    write_text(scene, R"(description = "a box"
size = [32, 32]
[camera]
clip_from_world = [[2, 0, 0, 0], [0, 2, 0, -2], [0, 0, 0, 0], [0, 0, -1, 5.5]]
near = 0.1
far = 50
[light]
shape = "sphere"
centre = [3, 3, 2]
radius = 0.3
[[object]]
shape = "box"
casts = true
size = [1, 1, 1]
)");
    write_depth({});
  }

  void write_depth(const std::filesystem::path& other, int width = kWidth) const {
    Image depth(width, kHeight, 2);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < width; ++x) {
        const float u = (static_cast<float>(x) + 0.5F) / 16.0F - 1.0F;  // clip space
        const float v = 1.0F - (static_cast<float>(y) + 0.5F) / 16.0F;
        float distance = v < 0.0F ? 2.0F / -v : 1e10F;
        if (std::abs(u) < 0.2F && v < 0.0F && v > -0.4F) distance = 5.0F;
        depth.pixel(x, y)[0] = 0.5F;
        depth.pixel(x, y)[1] = distance;
      }
    }
    write_image(other.empty() ? image : other, depth, {"A", "Z"});
  }

  Outcome import(std::vector<std::string> options) const {
    options.insert(options.begin(), {"import", scene.string(), "--depth-image", image.string(),
                                     "-o", file.string()});
    return run_command(options);
  }
};

TEST_F(Import, MakesATraceThatTheModelAgreesWith) {
  const Outcome outcome = import({"--meaning", "view"});
  expect_good(outcome);
  EXPECT_NE(outcome.out.find("pixels inside the casters"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(" 0 show what lies behind"), std::string::npos) << outcome.out;
  const traces::TraceFile written(file);
  EXPECT_EQ(written.view().header.width, 32U);
  int dark = 0;
  for (const double li : written.view().expected_li) dark += li < 0.5 ? 1 : 0;
  EXPECT_GT(dark, 5);  // the shadow on the floor that only the image knows
  expect_good(run_command({"count", file.string(), "--mode", "single-pass,three-pass"}));
}

TEST_F(Import, SaysWhatDoesNotFit) {
  const std::size_t entries = folder.entries();
  expect_bad_input(import({}), {"frame.exr: pixel 0,", "another --meaning"});
  expect_bad_input(import({"--meaning", "view", "--flip"}),
                   {"frame.exr", "lies behind", "options that fit: --meaning view"});
  expect_bad_input(import({"--meaning", "view", "--channel", "depth"}), {"no channel", "A, Z"});
  expect_bad_input(import({"--meaning", "metres"}), {"--meaning", "view"});
  expect_bad_input(import({"--meaning", "view", "--size", "16x16"}), {"32x32", "16x16"});
  expect_bad_input(import({"--meaning", "view", "--size", "32x16"}), {"clip_from_world"});
  expect_bad_input(run_command({"import", scene.string(), "-o", file.string()}), {"--depth-image"});
  expect_bad_input(run_command({"import", scene.string(), "--depth-image", image.string(), "-o",
                                image.string()}),
                   {"frame.exr"});
  expect_bad_input(
      run_command({"import", scene.string(), "--depth-image", scene.string(), "-o", file.string()}),
      {"frame.toml"});
  EXPECT_EQ(folder.entries(), entries);
}

}  // namespace
}  // namespace wedgesim::cli
