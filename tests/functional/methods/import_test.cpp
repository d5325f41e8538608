// Is another renderer's frame taken as it is, and is one that does not fit refused with the reason?
#include "functional/methods/import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/file.h"
#include "functional/geometry/segment.h"
#include "functional/scene/scene_file.h"
#include "tests/support/expect_input_error.h"
#include "traces/writer.h"

namespace wedgesim::functional {
namespace {

Scene load(const std::string& name, std::pair<int, int> size = {48, 32}) {
  SceneOptions options;
  options.size = size;
  std::vector<std::string> notes;
  return load_scene(name, options, &notes);
}

template <typename Value>
Image image_of(const Scene& scene, Value value) {
  Image image(scene.width, scene.height, 1);
  image.channel_names = {"Z"};
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) *image.pixel(x, y) = static_cast<float>(value(x, y));
  }
  return image;
}

// What the project's own rasterizer sees.
Image own_depth(const Scene& scene) {
  const DepthBuffer depth = render_depth(make_window(scene.camera, scene.width, scene.height),
                                         scene.objects, traces::fb::DepthFormat_unorm24);
  return image_of(scene, [&](int x, int y) {
    const auto i = static_cast<std::size_t>(y * scene.width + x);
    return traces::decode_depth(depth.format, depth.words[i]);
  });
}

// What a ray through each pixel's centre meets, tried against every triangle: its distance from
// the eye, or along the view. Infinite where it meets nothing.
Image ray_depth(const Scene& scene, bool along_view) {
  const Window window = make_window(scene.camera, scene.width, scene.height);
  return image_of(scene, [&](int x, int y) {
    const glm::dvec3 far = world_point(window, x + 0.5, y + 0.5, 1.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Object& object : scene.objects) {
      for (const auto& t : object.mesh.triangles) {
        const auto& p = object.mesh.positions;
        const auto share = segment_triangle(window.eye, far, p[t[0]], p[t[1]], p[t[2]]);
        if (share) nearest = std::min(nearest, *share * glm::distance(window.eye, far));
      }
    }
    const glm::dvec3 ray = glm::normalize(far - window.eye);
    return along_view ? nearest * glm::dot(ray, glm::normalize(scene.camera.target - window.eye))
                      : nearest;
  });
}

std::string bytes_of(const traces::Trace& trace) {
  const auto file = std::filesystem::path(testing::TempDir()) / "wedgesim_import_test.wtrace";
  traces::write_trace(file, trace);
  std::string bytes(MappedFile(file).text());
  std::filesystem::remove(file);
  return bytes;
}

TEST(Import, OfTheSameDepthIsTheSameTrace) {
  for (const char* name : {"plain-columns", "eye-in-shadow", "cylinder"}) {
    const Scene scene = load(name);
    const Import import = import_frame(scene, own_depth(scene), {}, "depth.exr");
    EXPECT_EQ(import.fit.behind, 0U) << name;
    EXPECT_EQ(import.fit.agree, import.fit.meshes) << name;
    EXPECT_TRUE(bytes_of(import.frame.trace) == bytes_of(make_frame(scene).trace)) << name;
  }
}

TEST(Import, RaysOfAnotherRendererGiveTheSameLight) {
  const Scene scene = load("plain-columns");
  const traces::Trace own = make_frame(scene).trace;
  for (const DepthMeaning meaning : {DepthMeaning::view, DepthMeaning::distance}) {
    ImportOptions options;
    options.meaning = meaning;
    const Import import =
        import_frame(scene, ray_depth(scene, meaning == DepthMeaning::view), options, "depth.exr");
    EXPECT_LE(import.fit.behind, 2U);
    int differ = 0;
    for (std::size_t i = 0; i < own.expected_li.size(); ++i) {
      const double difference = std::abs(import.frame.trace.expected_li[i] - own.expected_li[i]);
      differ += difference > 1e-3 + own.li_sensitivity[i] ? 1 : 0;
    }
    EXPECT_LE(differ, 5);  // at outlines: rays do not know of snapped vertices
  }
}

TEST(Import, ReceiversThatOnlyTheImageShowsAreReached) {
  const Scene whole = load("plain-columns");
  Scene casters = whole;
  std::erase_if(casters.objects, [](const Object& object) { return !object.casts; });
  const Import import = import_frame(casters, own_depth(whole), {}, "depth.exr");
  const traces::Trace own = make_frame(whole).trace;
  double worst = 0.0;
  for (std::size_t i = 0; i < own.expected_li.size(); ++i) {
    // LI is 1 - k on casters' far sides, whatever the volumes' ends.
    worst = std::max(worst, std::abs(import.frame.trace.expected_li[i] - own.expected_li[i]));
  }
  EXPECT_LT(worst, 1e-3);
}

TEST(Import, WhatDoesNotFitIsRefusedWithTheReason) {
  const Scene scene = load("plain-columns");
  const Image window = own_depth(scene);
  const auto error = [&](const Image& image, const ImportOptions& options = {}) {
    return input_error_of([&] { import_frame(scene, image, options, "d.exr"); });
  };
  const auto expect = [](const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) {
      EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" lacks " << part;
    }
  };
  expect(error(flipped(window)),
         {"d.exr", "lies behind", "options that fit: --meaning window --flip"});
  ImportOptions flip;
  flip.flip = true;
  EXPECT_EQ(error(flipped(window), flip), "");
  expect(error(ray_depth(scene, true)), {"pixel 0,0", "another --meaning"});
  ImportOptions view;
  view.meaning = DepthMeaning::view;
  Image distances = ray_depth(scene, false);
  EXPECT_EQ(error(distances, view).find("before the near plane"), std::string::npos);
  const Scene larger = load("plain-columns", {160, 107});
  Scene moved = larger;
  moved.camera.eye.x += 0.5;
  expect(input_error_of([&] { import_frame(moved, own_depth(larger), {}, "d.exr"); }),
         {"lies behind", "same camera"});
  // Other meanings that put everything before the casters.
  const Image depth = own_depth(larger);
  const auto misread = [&](DepthMeaning meaning, const Image& image, const Scene& of) {
    ImportOptions options;
    options.meaning = meaning;
    return input_error_of([&] { import_frame(of, image, options, "d.exr"); });
  };
  Scene wide = larger;
  wide.camera.field_of_view_degrees = 110.0;
  wide.camera.eye = 0.4 * wide.camera.eye;
  Image reversed = depth;
  for (float& value : reversed.values) value = 1.0F - value;
  expect(misread(DepthMeaning::window, reversed, larger),
         {"options that fit better: --meaning reversed"});
  expect(misread(DepthMeaning::distance, ray_depth(wide, true), wide),
         {"options that fit better: --meaning view"});
  Scene slightly = larger;
  slightly.camera.eye.x += 0.15;
  const DepthFit outline = import_frame(slightly, depth, {}, "d.exr").fit;
  EXPECT_GT(20 * outline.outline_behind, outline.outline);
  EXPECT_EQ(import_frame(larger, depth, {}, "d.exr").fit.outline_behind, 0U);
  Image broken = window;
  *broken.pixel(5, 7) = std::numeric_limits<float>::quiet_NaN();
  expect(error(broken), {"d.exr: pixel 5,7", "nan"});
  expect(error(Image(48, 33, 1)), {"48x33", "48x32"});
  Image colours(48, 32, 3);
  colours.channel_names = {"R", "G", "B"};
  expect(error(colours), {"none called Z", "R, G, B"});
}

}  // namespace
}  // namespace wedgesim::functional
