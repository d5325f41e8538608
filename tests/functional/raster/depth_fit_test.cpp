// Which pixels agree with the meshes, and when does a frame not fit?
#include "functional/raster/depth_fit.h"

#include <gtest/gtest.h>

namespace wedgesim::functional {
namespace {

// A wall at `distance` over all pixels but the last column, seen along -z.
struct Wall {
  static constexpr int kWidth = 12;
  static constexpr int kHeight = 12;
  Window window;
  DepthBuffer meshes;

  Wall() {
    Camera camera;
    camera.target = {0.0, 0.0, -1.0};
    camera.near_plane = 1.0;
    camera.far_plane = 100.0;
    window = make_window(camera, kWidth, kHeight);
    meshes = at(10.0);
    meshes.triangle.assign(meshes.words.size(), 0);
    for (std::size_t i = kWidth - 1; i < meshes.words.size(); i += kWidth) {
      meshes.triangle[i] = DepthBuffer::kSky;
      meshes.words[i] = traces::sky_word(meshes.format);
    }
  }
  DepthBuffer at(double distance) const {
    DepthBuffer depth;
    depth.format = traces::fb::DepthFormat_unorm24;
    depth.width = kWidth;
    depth.height = kHeight;
    const double z = window_depth(window, distance);
    depth.words.assign(kWidth * kHeight, traces::encode_depth(depth.format, z));
    return depth;
  }
};

TEST(DepthFit, CountsEveryPixelOnceAndLeavesOutlinesAlone) {
  const Wall wall;
  const DepthFit same = fit_depth(wall.window, wall.at(10.0), wall.meshes, 0.01);
  EXPECT_EQ(same.agree, same.meshes);
  EXPECT_EQ(same.meshes, 10U * 12U);  // of 12 columns: not the last, not its neighbour
  EXPECT_TRUE(same.fits());
}

TEST(DepthFit, ToleranceIsAPartOfTheDistance) {
  const Wall wall;
  EXPECT_EQ(fit_depth(wall.window, wall.at(10.09), wall.meshes, 0.01).behind, 0U);
  EXPECT_EQ(fit_depth(wall.window, wall.at(9.91), wall.meshes, 0.01).hidden, 0U);
  const DepthFit far = fit_depth(wall.window, wall.at(10.11), wall.meshes, 0.01);
  EXPECT_EQ(far.behind, far.meshes);
  EXPECT_FALSE(far.fits());
  EXPECT_EQ(far.first_behind, (std::array{0, 0}));
  const DepthFit near = fit_depth(wall.window, wall.at(9.89), wall.meshes, 0.01);
  EXPECT_EQ(near.hidden, near.meshes);
  EXPECT_TRUE(near.fits());
}

TEST(DepthFit, AFewPixelsBehindAreTaken) {
  const Wall wall;
  DepthBuffer depth = wall.at(10.0);
  const std::uint32_t behind = wall.at(20.0).words[0];
  depth.words[0] = behind;  // 1 of 120
  EXPECT_TRUE(fit_depth(wall.window, depth, wall.meshes, 0.01).fits());
  depth.words[1] = behind;
  EXPECT_FALSE(fit_depth(wall.window, depth, wall.meshes, 0.01).fits());
}

}  // namespace
}  // namespace wedgesim::functional
