// What a frame is made of, edge by edge: to check kernels that draw many points at once against
// sums at one point.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "functional/light/coverage.h"
#include "functional/methods/brute_force.h"
#include "functional/methods/frame.h"
#include "functional/methods/render.h"

namespace wedgesim::functional {

// What a pixel is made of: whole shadows, and what its edges hide, below 0 if it is taken away.
struct Pixel {
  double umbra = 1.0;
  std::vector<float> shares;
};

/// What an edge hides of the light at a point in light space.
using EdgeShare = std::function<float(const glm::dvec3& point, const ShadowWedge& wedge)>;

inline std::vector<Pixel> pixels_by_hand(const Scene& scene, const View& view,
                                         const EdgeShare& edge_share) {
  FrameOptions options;
  options.depth = &view.depth;
  options.depth_format = view.depth.format;
  const Frame frame = make_frame(scene, options);
  std::vector<std::size_t> all(view.depth.words.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<double> exact =
      brute_force_light_intensity(scene, frame.window, frame.depth, frame.geometry, all);
  const glm::dmat4 to_light = light_from_world(scene.light);
  std::vector<Pixel> pixels(all.size());
  for (const std::size_t i : all) {
    if (view.depth.triangle[i] == DepthBuffer::kSky) continue;
    const auto width = static_cast<std::size_t>(view.window.width);
    const glm::dvec3 p = world_point(view.window, static_cast<double>(i % width) + 0.5,
                                     static_cast<double>(i / width) + 0.5,
                                     traces::decode_depth(view.depth.format, view.depth.words[i]));
    const glm::dvec3 in_light(to_light * glm::dvec4(p, 1.0));
    double umbra = exact[i];
    for (const ShadowWedge& wedge : frame.geometry.wedges) {
      const double sign = wedge.umbra_plane.inside(p) ? 1.0 : -1.0;
      const double covered =
          coverage(scene.light.shape, in_light, wedge.light_begin, wedge.light_end);
      umbra -= sign * covered;
      const float is = edge_share(in_light, wedge);
      if (is != 0.0F) pixels[i].shares.push_back(static_cast<float>(sign) * is);
    }
    pixels[i].umbra = std::round(umbra);
  }
  return pixels;
}

inline double in_floats(const Pixel& pixel) {
  return std::accumulate(pixel.shares.begin(), pixel.shares.end(), pixel.umbra);
}

struct Difference {
  double largest = 0.0;
  double share_off = 0.0;  // of the pixels that some edge counts in, more than `same`
  int beyond = 0;          // pixels, more than `flip` for each end of an edge
};

template <typename Sum>
Difference compare(const std::vector<float>& values, const std::vector<Pixel>& pixels,
                   const Sum& sum, double same, double flip = 0.0) {
  Difference difference;
  int off = 0;
  int seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (pixels[i].shares.empty()) continue;
    const double d = std::abs(static_cast<double>(values[i]) - sum(pixels[i]));
    difference.largest = std::max(difference.largest, d);
    const double ends = 2.0 * static_cast<double>(pixels[i].shares.size());
    difference.beyond += d > same + ends * flip ? 1 : 0;
    off += d > same ? 1 : 0;
    ++seen;
  }
  EXPECT_GT(seen, 300);
  difference.share_off = static_cast<double>(off) / seen;
  return difference;
}

}  // namespace wedgesim::functional
