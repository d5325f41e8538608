// Paper IV's shaders as `ssv-optimized:shader=tables` and `vbuffer=12bit` run them, many points at
// once and by tiles, against the shaders at one point (shader_tables.h) summed by hand over every
// edge of the scene, and against rays.
#include "functional/methods/shader_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "functional/light/shader_tables.h"
#include "functional/methods/render.h"
#include "functional/reference/reference.h"
#include "functional/scene/primitives.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/methods/by_hand.h"

namespace wedgesim::functional {
namespace {

Scene scene_of(const std::string& name, LightShape shape) {
  SceneOptions options;
  options.size = {160, 107};
  options.light_shape = shape;
  return load_scene(name, options);
}

View view_of(const Scene& scene, const std::string& options) {
  return render_view(scene, choose_method("test", "ssv-optimized" + options));
}

EdgeShare edge_share(LightShape shape, bool tables) {
  return [shape, tables](const glm::dvec3& point, const ShadowWedge& wedge) {
    static const SectorTable disc = SectorTable::disc();
    static const SectorTable square = SectorTable::square();
    const glm::dvec3& begin = wedge.light_begin;
    const glm::dvec3& end = wedge.light_end;
    if (!tables) return static_cast<float>(coverage(shape, point, begin, end));
    return shape == LightShape::sphere ? shader_sphere_coverage(disc, point, begin, end)
                                       : shader_rectangle_coverage(square, point, begin, end);
  };
}

double in_split_words(const Pixel& pixel) {
  SplitWord added;
  SplitWord taken;
  for (const float share : pixel.shares) {
    (share > 0.0F ? added : taken).add(split_coverage(std::abs(share)));
  }
  return pixel.umbra + static_cast<double>(added.unpack() - taken.unpack()) / SplitWord::kWhole;
}

class ShaderKernel : public testing::TestWithParam<LightShape> {};
INSTANTIATE_TEST_SUITE_P(Lights, ShaderKernel,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::sphere ? "sphere" : "rectangle";
                         });

// Points within some thousandths of a radius of a caster's silhouette edge that they lie beside.
constexpr int kMostOthers = 4;

// The same arithmetic. Where an angle is as near to the next of the map's texels, 1/64 radian away,
// rounding may choose that: 1/64 of 2π of a disc, at most 1/64 of 4 of a square. Upright edges are
// between two texels at every point of `cylinder`.
TEST_P(ShaderKernel, IsTheShaderSummedOverAllEdges) {
  const double flip =
      GetParam() == LightShape::sphere ? 1.0 / 64.0 / (2.0 * std::numbers::pi) : 1.0 / 64.0 / 4.0;
  for (const char* name : {"cylinder", "columns", "fractal"}) {
    const Scene scene = scene_of(name, GetParam());
    const View view = view_of(scene, ":shader=tables");
    const Difference off =
        compare(view.visibility.values, pixels_by_hand(scene, view, edge_share(GetParam(), true)),
                in_floats, 1e-4, 1.01 * flip);
    std::cout << name << ": largest difference " << off.largest << ", more than 1e-4 at "
              << 100.0 * off.share_off << " % of the pixels, not explained at " << off.beyond
              << '\n';
    EXPECT_LE(off.beyond, kMostOthers);
    EXPECT_LT(off.share_off, name == std::string("cylinder") ? 0.2 : 0.05);
  }
}

// A word is two units of 4095 from the next, and rounding may choose either.
TEST_P(ShaderKernel, SplitsAsTheWordsDo) {
  for (const bool tables : {false, true}) {
    const Scene scene = scene_of("plain-columns", GetParam());
    const View view = view_of(scene, tables ? ":shader=tables,vbuffer=12bit" : ":vbuffer=12bit");
    const Difference off =
        compare(view.visibility.values, pixels_by_hand(scene, view, edge_share(GetParam(), tables)),
                in_split_words, 1e-4);
    std::cout << (tables ? "tables" : "exact") << ": largest difference " << off.largest
              << ", some at " << 100.0 * off.share_off << " % of the pixels\n";
    EXPECT_LT(off.largest, tables ? 0.01 : 4.5 / SplitWord::kWhole);
  }
}

// A fence whose pickets' edges are seen by every point below: more contributions than components
// of 8 bits hold. They stay at 255, as SplitWord::add has it.
TEST_P(ShaderKernel, ComponentsStayAt255) {
  Scene scene;
  scene.width = 64;
  scene.height = 48;
  scene.camera.eye = {0.0, 6.0, 6.0};
  scene.light.shape = GetParam();
  scene.light.centre = {0.0, 8.0, 0.0};
  scene.light.half_u = {2.0, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 1.0};
  scene.light.radius = 1.5;
  Object floor;
  floor.mesh = make_plane({8.0, 8.0}, {1, 1});
  scene.objects.push_back(floor);
  for (int i = 0; i < 120; ++i) {
    Object picket;
    picket.casts = true;
    picket.mesh = make_box({0.01, 0.02, 3.0});
    for (glm::dvec3& p : picket.mesh.positions) p += glm::dvec3(0.02 * (i - 59.5), 4.0, 0.0);
    scene.objects.push_back(picket);
  }
  const View view = view_of(scene, ":vbuffer=12bit");
  const std::vector<Pixel> pixels = pixels_by_hand(scene, view, edge_share(GetParam(), false));
  const Difference off = compare(view.visibility.values, pixels, in_split_words, 0.05);
  const Difference lost = compare(view.visibility.values, pixels, in_floats, 0.05);
  std::cout << "of the words by hand: " << off.largest << ", " << 100.0 * off.share_off
            << " %; of the exact sums: " << lost.largest << ", " << 100.0 * lost.share_off
            << " %\n";
  EXPECT_GT(lost.share_off, 0.2) << "no component is full";
  EXPECT_LT(off.share_off, 0.01);
}

TEST_P(ShaderKernel, IsNearRays) {
  for (const char* name : {"cylinder", "plain-columns"}) {
    const Scene scene = scene_of(name, GetParam());
    const View exact = view_of(scene, "");
    const std::vector<float> reference =
        reference_visibility(scene, exact.window, exact.depth, 1024);
    const auto rmse = [&](const View& view) {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t i = 0; i < reference.size(); ++i) {
        if (view.depth.triangle[i] == DepthBuffer::kSky) continue;
        if (scene.objects[view.depth.surface(i).object].casts) continue;
        const float shown = std::clamp(view.visibility.values[i], 0.0F, 1.0F);
        sum += std::pow(static_cast<double>(shown - reference[i]), 2.0);
        count += 1.0;
      }
      return std::sqrt(sum / count);
    };
    const double tables = rmse(view_of(scene, ":shader=tables"));
    const double words = rmse(view_of(scene, ":shader=tables,vbuffer=12bit"));
    std::cout << name << ": RMSE " << rmse(exact) << ", by tables " << tables << ", and in 12 bits "
              << words << '\n';
    EXPECT_LT(tables, 0.003);
    EXPECT_LT(words, 0.003);
  }
}

}  // namespace
}  // namespace wedgesim::functional
