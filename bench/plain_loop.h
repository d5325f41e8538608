#pragma once

#include <cstdint>
#include <vector>

#include "model/count/primitive.h"
#include "traces/trace.h"

namespace wedgesim::bench {

enum class Light { linear, rectangle, sphere };
/// broad: wedges of all sizes over a smooth floor. thin: slivers a few pixels wide, as the wedges
/// of fine meshes are. noisy: broad, over depths that vary from pixel to pixel.
enum class Shape { broad, thin, noisy };

/// Wedges in front of, in and behind a floor that rises towards a wall.
struct Scene {
  Scene(Light light, Shape shape);

  traces::Trace trace;
  std::vector<model::Primitive> wedges;
  std::vector<double> z;  // (height, width)
};

/// (height, width) sums of contributions.
struct Image {
  explicit Image(std::size_t pixels) : penumbra(pixels), umbra(pixels) {}
  std::vector<std::int64_t> penumbra;
  std::vector<std::int32_t> umbra;
};

/// The baseline that the kernels are held against: polygons, rows, pixels, in plain C++. Rasterizes
/// each wedge, tests the depth of every pixel that its faces cover, evaluates and adds its
/// contributions, the umbra polygons' too.
/// \return pixel visits
std::uint64_t draw_plainly(const Scene& scene, Image& image);

}  // namespace wedgesim::bench
