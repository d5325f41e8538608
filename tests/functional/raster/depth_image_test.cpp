// Does each meaning of a depth image's values come to the same stored depth?
#include "functional/raster/depth_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

using traces::fb::DepthFormat_float32;

Window window() {
  Camera camera;
  camera.eye = {1.0, 2.0, 3.0};
  camera.target = {0.0, 0.0, -1.0};
  camera.near_plane = 0.5;
  camera.far_plane = 40.0;
  return make_window(camera, 5, 3);
}

DepthBuffer depth_of(const Image& image, DepthMeaning meaning) {
  return depth_of_image(image, 0, meaning, window(), DepthFormat_float32, "d.exr");
}

TEST(DepthImage, EveryMeaningOfOnePointIsOneDepth) {
  const Window w = window();
  const int x = 4;
  const int y = 0;
  for (const double z : {0.0, 0.3, 0.9, 0.99}) {
    const glm::dvec3 p = world_point(w, x + 0.5, y + 0.5, z);
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(0.0, 0.0, -1.0) - w.eye);
    for (const auto& [meaning, value] :
         {std::pair{DepthMeaning::window, z}, std::pair{DepthMeaning::reversed, 1.0 - z},
          std::pair{DepthMeaning::ndc, 2.0 * z - 1.0},
          std::pair{DepthMeaning::view, glm::dot(p - w.eye, ahead)},
          std::pair{DepthMeaning::distance, glm::distance(p, w.eye)}}) {
      Image image(5, 3, 1);
      std::ranges::fill(image.values, 0.6F);
      *image.pixel(x, y) = static_cast<float>(value);
      const DepthBuffer depth = depth_of(image, meaning);
      const double stored = traces::decode_depth(depth.format, depth.words[4]);
      EXPECT_NEAR(stored, z, 2e-7) << static_cast<int>(meaning);
    }
  }
}

TEST(DepthImage, BeyondTheFarPlaneIsSky) {
  Image image(5, 3, 1);
  std::ranges::fill(image.values, std::numeric_limits<float>::infinity());
  *image.pixel(0, 0) = 41.0F;
  *image.pixel(1, 0) = 39.0F;
  const DepthBuffer depth = depth_of(image, DepthMeaning::view);
  const std::uint32_t sky = traces::sky_word(DepthFormat_float32);
  EXPECT_EQ(depth.words[0], sky);
  EXPECT_NE(depth.words[1], sky);
  EXPECT_EQ(depth.words[14], sky);
}

TEST(DepthImage, ValuesThatAreNoDepthAreRefused) {
  for (const auto& [meaning, value] :
       {std::pair{DepthMeaning::window, 1.01F}, std::pair{DepthMeaning::window, -0.01F},
        std::pair{DepthMeaning::ndc, -1.01F}, std::pair{DepthMeaning::view, 0.0F},
        std::pair{DepthMeaning::view, 0.4F}, std::pair{DepthMeaning::distance, -1.0F},
        std::pair{DepthMeaning::distance, std::nanf("")}}) {
    Image image(5, 3, 1);
    std::ranges::fill(image.values, 0.9F);
    *image.pixel(3, 2) = value;
    const std::string error = input_error_of([&] { depth_of(image, meaning); });
    EXPECT_NE(error.find("d.exr: pixel 3,2"), std::string::npos) << value << error;
  }
}

TEST(DepthImage, FlippedTwiceIsTheSame) {
  Image image(2, 3, 2);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i);
  EXPECT_EQ(*flipped(image).pixel(1, 0), *image.pixel(1, 2));
  EXPECT_EQ(flipped(flipped(image)).values, image.values);
}

}  // namespace
}  // namespace wedgesim::functional
