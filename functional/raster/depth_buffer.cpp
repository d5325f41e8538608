#include "functional/raster/depth_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "functional/raster/clip.h"
#include "functional/raster/spans.h"

namespace wedgesim::functional {
namespace {

constexpr int kBandRows = 16;

// A triangle on the screen, or one of the convex parts that its clipped outline snapped into.
struct ScreenPart {
  std::vector<SnappedPoint> outline;
  glm::dvec4 plane;  // window space
  double z_min = 0.0;
  double z_max = 0.0;
  int y_begin = 0;
  int y_end = 0;
  std::uint32_t triangle = 0;
};

void prepare(const Window& window, const Mesh& mesh, std::uint32_t first_id,
             std::vector<ScreenPart>& parts) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corner = mesh.triangles[t];
    const std::array<glm::dvec3, 3> p{mesh.positions[corner[0]], mesh.positions[corner[1]],
                                      mesh.positions[corner[2]]};
    const std::vector<WindowPoint> points = clip_to_window(window, p);
    if (points.empty()) continue;
    ScreenPart part;
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    part.plane = window_plane(window, glm::dvec4(normal, -glm::dot(normal, p[0])));
    const auto [near, far] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    part.z_min = near->z;
    part.z_max = far->z;
    part.triangle = first_id + static_cast<std::uint32_t>(t);
    for (auto& outline : convex_parts(snap(points))) {
      if (doubled_area(outline) == 0) continue;
      part.outline = std::move(outline);
      const auto [low, high] =
          std::minmax_element(part.outline.begin(), part.outline.end(),
                              [](const auto& a, const auto& b) { return a.y < b.y; });
      part.y_begin = std::max(0, (low->y - 128) >> 8);
      part.y_end = std::min(window.height, ((high->y - 128) >> 8) + 1);
      if (part.y_begin < part.y_end) parts.push_back(part);
    }
  }
}

bool nearer(traces::fb::DepthFormat format, std::uint32_t a, std::uint32_t b) {
  return format == traces::fb::DepthFormat_float32_reversed ? a > b : a < b;
}

}  // namespace

DepthBuffer::Surface DepthBuffer::surface(std::size_t pixel) const {
  const std::uint32_t id = triangle[pixel];
  const auto next = std::upper_bound(first_triangle.begin(), first_triangle.end(), id);
  const auto object = static_cast<std::uint32_t>(next - first_triangle.begin() - 1);
  return {object, id - first_triangle[object]};
}

DepthBuffer render_depth(const Window& window, std::span<const Object> objects,
                         traces::fb::DepthFormat format) {
  DepthBuffer buffer;
  buffer.format = format;
  buffer.width = window.width;
  buffer.height = window.height;
  const auto pixels =
      static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  buffer.words.assign(pixels, traces::sky_word(format));
  buffer.triangle.assign(pixels, DepthBuffer::kSky);

  std::vector<ScreenPart> parts;
  std::uint32_t first = 0;
  for (const Object& object : objects) {
    buffer.first_triangle.push_back(first);
    prepare(window, object.mesh, first, parts);
    first += static_cast<std::uint32_t>(object.mesh.triangles.size());
  }
  buffer.first_triangle.push_back(first);

  const int bands = (window.height + kBandRows - 1) / kBandRows;
  tbb::parallel_for(0, bands, [&](int band) {
    const int y_begin = band * kBandRows;
    const int y_end = std::min(window.height, y_begin + kBandRows);
    for (const ScreenPart& part : parts) {
      if (part.y_begin >= y_end || part.y_end <= y_begin) continue;
      const glm::dvec4& plane = part.plane;
      for_each_span(part.outline, window.width, y_begin, y_end, [&](int y, int x0, int x1) {
        for (int x = x0; x < x1; ++x) {
          const double v = plane.x * (x + 0.5) + plane.y * (y + 0.5) + plane.w;
          const double z = plane.z != 0.0 ? -v / plane.z : part.z_min;
          const std::uint32_t word =
              traces::encode_depth(format, std::clamp(z, part.z_min, part.z_max));
          const std::size_t pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
              static_cast<std::size_t>(x);
          const bool first_here = buffer.triangle[pixel] == DepthBuffer::kSky;
          if (nearer(format, word, buffer.words[pixel]) ||
              (first_here && word == buffer.words[pixel])) {
            buffer.words[pixel] = word;
            buffer.triangle[pixel] = part.triangle;
          }
        }
      });
    }
  });
  return buffer;
}

}  // namespace wedgesim::functional
