// Does every built-in scene still give the light intensity of its golden image?
// docs/testing.md tells how to refresh them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/image.h"
#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "tests/golden/golden.h"

namespace wedgesim::tests {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 107;
constexpr std::uintmax_t kMostBytes = 10 * 1024;

std::filesystem::path path_of(const std::string& scene) {
  return golden_folder() / (scene + ".png");
}

// The expected light intensity of the first frame, clamped.
Image render(const std::string& name) {
  functional::SceneOptions options;
  options.size = {kWidth, kHeight};
  const functional::Frame frame = functional::make_frame(functional::load_scene(name, options));
  Image image(kWidth, kHeight, 1);
  std::transform(frame.trace.expected_li.begin(), frame.trace.expected_li.end(),
                 image.values.begin(),
                 [](double li) { return static_cast<float>(std::clamp(li, 0.0, 1.0)); });
  return image;
}

int level(float value) { return static_cast<int>(std::lround(255.0F * value)); }

void compare(const Image& image, const Image& golden) {
  ASSERT_EQ(golden.width, image.width);
  ASSERT_EQ(golden.height, image.height);
  ASSERT_EQ(golden.channels, 1);
  int worst = 0;
  int worst_x = 0;
  int worst_y = 0;
  int beyond = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int difference = std::abs(level(*image.pixel(x, y)) - level(*golden.pixel(x, y)));
      beyond += difference > 1 ? 1 : 0;
      if (difference <= worst) continue;
      worst = difference;
      worst_x = x;
      worst_y = y;
    }
  }
  EXPECT_LE(worst, 1) << beyond << " pixels differ; worst (" << worst_x << ", " << worst_y
                      << "): " << level(*image.pixel(worst_x, worst_y)) << ", golden "
                      << level(*golden.pixel(worst_x, worst_y)) << " of 255";
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const functional::SceneInfo& info : functional::built_in_scenes()) {
    names.push_back(info.name);
  }
  return names;
}

class GoldenImages : public testing::TestWithParam<std::string> {};

TEST_P(GoldenImages, AreStillRendered) {
  const std::string& name = GetParam();
  if (!can_load(name)) GTEST_SKIP() << "the package of the mesh is not installed";
  const Image image = render(name);
  if (updates_golden()) write_image(path_of(name), image);
  compare(image, read_image(path_of(name)));
  EXPECT_LE(std::filesystem::file_size(path_of(name)), kMostBytes);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, GoldenImages, testing::ValuesIn(scene_names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(GoldenImagesFolder, HoldsNoOthers) {
  const std::vector<std::string> names = scene_names();
  const std::set<std::string> scenes(names.begin(), names.end());
  for (const auto& entry : std::filesystem::directory_iterator(golden_folder())) {
    if (entry.path().extension() != ".png") continue;
    EXPECT_TRUE(scenes.contains(entry.path().stem().string())) << entry.path();
  }
}

}  // namespace
}  // namespace wedgesim::tests
