#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functional/raster/window.h"
#include "functional/scene/scene.h"
#include "traces/depth.h"

namespace wedgesim::functional {

/// What the eye sees: the nearest surface at every pixel centre.
struct DepthBuffer {
  static constexpr std::uint32_t kSky = 0xffffffffU;

  traces::fb::DepthFormat format = traces::fb::DepthFormat_unorm24;
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> words;     // (height, width) stored depth
  std::vector<std::uint32_t> triangle;  // (height, width) triangle of the scene, or kSky

  /// The object and the triangle in it of a triangle of the scene (objects one after the other).
  struct Surface {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0;
  };
  Surface surface(std::size_t pixel) const;

  std::vector<std::uint32_t> first_triangle;  // of each object, then the number of all
};

/// Rasterizes all objects of a scene with the snapped vertices and the top-left rule. The depth at
/// a pixel is that of the triangle's unsnapped plane, kept within the depths of its vertices; of
/// equal stored words the first triangle wins.
DepthBuffer render_depth(const Window& window, std::span<const Object> objects,
                         traces::fb::DepthFormat format);

}  // namespace wedgesim::functional
