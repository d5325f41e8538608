// `ssv` with a coverage texture or a light's texture, many points at once and by tiles, against
// lookups and integrals at one point (coverage_texture.h, emission.h) summed by hand over every
// edge of the scene.
#include "functional/methods/texture_kernel.h"

#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "functional/scene/light_texture.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/methods/by_hand.h"

namespace wedgesim::functional {
namespace {

struct Case {
  std::string name, options;
  bool textured;
  int side;  // 0: exact clipping
  TextureFilter filter;
  CoverageWords words;
};

class TextureKernel : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Textures, TextureKernel,
    testing::Values(
        Case{"even", ":texture=32", false, 32, TextureFilter::nearest, CoverageWords::bits8},
        Case{"even_floats", ":texture=16,words=float", false, 16, TextureFilter::nearest,
             CoverageWords::float32},
        Case{"even_quadlinear", ":texture=16,filter=quadlinear", false, 16,
             TextureFilter::quadlinear, CoverageWords::bits8},
        Case{"fire_exact", "", true, 0, TextureFilter::nearest, CoverageWords::bits8},
        Case{"fire", ":texture=16", true, 16, TextureFilter::nearest, CoverageWords::bits8},
        Case{"fire_quadlinear", ":texture=12,filter=quadlinear", true, 12,
             TextureFilter::quadlinear, CoverageWords::bits8},
        Case{"fire_quadlinear_floats", ":texture=8,filter=quadlinear,words=float", true, 8,
             TextureFilter::quadlinear, CoverageWords::float32}),
    [](const auto& parameter) { return parameter.param.name; });

// Where a coordinate is as near to two entries, or a chord as near to the centre as rounding,
// single precision may choose the other: then the nearest entry's value is another, not the
// interpolated one.
TEST_P(TextureKernel, IsTheLookupsSummedOverAllEdges) {
  const Case& is = GetParam();
  SceneOptions options;
  options.size = {160, 107};
  options.light_shape = LightShape::rectangle;
  Scene scene = load_scene("columns", options);
  if (is.textured) scene.light.texture = std::make_shared<const Image>(make_fire(0, 16, 32, 1));
  const Emission emission =
      is.textured ? Emission(emission_shares(*scene.light.texture)) : Emission();
  const auto table =
      is.side > 0 ? coverage_texture(scene.light.texture, is.side, is.words) : nullptr;
  const View view = render_view(scene, choose_method("test", "ssv" + is.options));
  const auto channels = static_cast<std::size_t>(emission.channels());
  ASSERT_EQ(view.visibility.channels, emission.channels());
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const auto looked_up = [&](const glm::dvec3& point, const ShadowWedge& wedge) {
      const auto chord = project_edge(point, wedge.light_begin, wedge.light_end);
      if (!chord) return 0.0F;
      if (!table) return static_cast<float>(emission.beyond(chord->p, chord->q)[channel]);
      return (is.filter == TextureFilter::nearest ? table->nearest(chord->p, chord->q)
                                                  : table->quadlinear(chord->p, chord->q))[channel];
    };
    std::vector<float> values;
    for (std::size_t i = channel; i < view.visibility.values.size(); i += channels) {
      values.push_back(view.visibility.values[i]);
    }
    const Difference off = compare(values, pixels_by_hand(scene, view, looked_up), in_floats, 1e-4);
    std::cout << "channel " << channel << ": largest difference " << off.largest
              << ", more than 1e-4 at " << 100.0 * off.share_off << " % of the pixels\n";
    EXPECT_LT(off.share_off, 0.01);
  }
}

}  // namespace
}  // namespace wedgesim::functional
