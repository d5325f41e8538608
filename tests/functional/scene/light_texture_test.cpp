#include "functional/scene/light_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "functional/scene/light_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

constexpr int kSide = 32;

double difference(const Image& a, const Image& b, int shift) {
  double sum = 0.0;
  for (int y = 0; y + shift < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      sum += std::abs(a.pixel(x, y)[0] - b.pixel(x, y + shift)[0]);
    }
  }
  return sum / (kSide * (kSide - shift));
}

TEST(Fire, IsTheSameEveryTimeAndRepeats) {
  EXPECT_EQ(make_fire(3, 16, kSide, 1).values, make_fire(3, 16, kSide, 1).values);
  EXPECT_NE(make_fire(3, 16, kSide, 1).values, make_fire(3, 16, kSide, 2).values);
  EXPECT_EQ(make_fire(16, 16, kSide, 1).values, make_fire(0, 16, kSide, 1).values);
  for (const float value : make_fire(5, 16, kSide, 1).values) {
    ASSERT_TRUE(value >= 0.0F && value <= 1.0F);
  }
}

// Rows run from the tip down: a picture is more like the part of an earlier one that was below.
TEST(Fire, Rises) {
  constexpr int kFrames = 64;
  for (int frame = 0; frame < kFrames; frame += 8) {
    const Image now = make_fire(frame, kFrames, kSide, 1);
    const Image next = make_fire(frame + 1, kFrames, kSide, 1);
    EXPECT_LT(difference(next, now, 1), difference(now, next, 1)) << frame;
  }
}

TEST(Fire, IsRedAtItsEdgeYellowInsideAndDarkAround) {
  const Image fire = make_fire(0, 16, kSide, 1);
  EXPECT_EQ(fire.pixel(0, 0)[0], 0.0F);
  double power[3] = {};
  for (std::size_t i = 0; i < fire.values.size(); ++i) power[i % 3] += fire.values[i];
  EXPECT_GT(power[0], 1.2 * power[1]);
  EXPECT_GT(power[1], 1.5 * power[2]);
  EXPECT_GT(fire.pixel(kSide / 2, kSide - 1)[1], 0.8F);
}

class LightTextures : public testing::Test {
 protected:
  std::string write(const std::string& name, int width, int height, int channels, float value) {
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = value;
    write_image(folder_ / name, image);
    return (folder_ / name).string();
  }
  Light read(const std::string& keys, int frame = 0) {
    const toml::table root =
        parse_toml("centre = [0, 5, 0]\nhalf_u = [1, 0, 0]\nhalf_v = [0, 0, 2]\n" + keys, "a.toml");
    return read_light(TomlTable(root, "a.toml"), {folder_.path(), frame}).light;
  }
  std::string error(const std::string& keys) {
    std::string text = input_error_of([&] { read(keys); });
    const std::string folder = folder_.path().string() + "/";
    if (text.starts_with(folder)) text.erase(0, folder.size());
    return text;
  }
  TemporaryFolder folder_;
};

TEST_F(LightTextures, ExrIsLinearAndPngFollowsTheCurve) {
  const Image exr = read_light_texture(write("a.exr", 3, 2, 3, 4.5F));
  EXPECT_EQ(exr.width, 3);
  EXPECT_EQ(exr.values, std::vector<float>(18, 4.5F));
  const Image png = read_light_texture(write("a.png", 2, 2, 1, 188.0F / 255.0F));
  ASSERT_EQ(png.values.size(), 12U) << "grey becomes three colours";
  EXPECT_NEAR(png.values[5], 0.5029F, 1e-4F);
}

TEST_F(LightTextures, AFrameShowsItsPictureOfASequence) {
  write("a.exr", 1, 1, 3, 1.0F);
  write("b.exr", 1, 1, 3, 2.0F);
  const std::string keys = "textures = ['a.exr', 'b.exr']";
  for (int frame = 0; frame < 5; ++frame) {
    EXPECT_EQ(read(keys, frame).texture->values[0], frame % 2 == 0 ? 1.0F : 2.0F);
  }
  EXPECT_EQ(read("").texture, nullptr);
  const std::string fire = "fire = {frames = 4, side = 8, seed = 3}";
  EXPECT_EQ(read(fire, 5).texture->values, make_fire(1, 4, 8, 3).values);
}

TEST_F(LightTextures, BadOnesAreNamed) {
  EXPECT_EQ(error("textures = ['a.png']").substr(0, 5), "a.png");
  write("black.png", 2, 2, 3, 0.0F);
  EXPECT_EQ(error("textures = ['black.png']"),
            "black.png: is black; expected a light texture that emits light");
  write("wide.png", 300, 2, 3, 1.0F);
  EXPECT_EQ(error("textures = ['wide.png']"),
            "wide.png: has 300 x 2 pixels; expected a light texture of at most 256 each way");
  write("less.exr", 2, 2, 3, -1.0F);
  EXPECT_EQ(error("textures = ['less.exr']"),
            "less.exr: pixel (0, 0) is -1; expected finite values from 0");
  write("two.exr", 2, 2, 2, 1.0F);
  EXPECT_EQ(error("textures = ['two.exr']"), "two.exr: has 2 channels; expected grey, RGB or RGBA");
  EXPECT_EQ(error("textures = []"),
            "a.toml:4: 'textures' is not an array of strings; expected an array of strings, at "
            "least one");
  EXPECT_EQ(error("textures = ['a.exr']\nfire = {}"),
            "a.toml:4: 'textures' stands beside 'fire'; expected one of them");
  EXPECT_EQ(error("fire = {size = 3}"),
            "a.toml:4: unknown key 'size'; expected one of frames, side, seed");
}

TEST(LightTexturesOfOthers, AreUnknownKeys) {
  const toml::table root =
      parse_toml("shape = 'sphere'\ncentre = [0, 5, 0]\nradius = 1\nfire = {}", "a");
  EXPECT_NE(input_error_of([&] { read_light(TomlTable(root, "a")); }).find("unknown key 'fire'"),
            std::string::npos);
}

}  // namespace
}  // namespace wedgesim::functional
