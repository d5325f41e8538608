#include "bench/plain_loop.h"

#include <algorithm>
#include <random>

#include "tests/model/count/synthetic.h"
#include "traces/depth.h"

namespace wedgesim::bench {
namespace {

using namespace model;  // NOLINT: the vocabulary of the loop

constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 427;
constexpr std::uint32_t kSeed = 2002;

void set_depth(traces::Trace& trace, bool noisy) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const double up = 1.0 - static_cast<double>(i / kWidth) / kHeight;
    const double depth = std::min(0.3 + 0.4 * up, 0.55) + (noisy ? noise(random) : 0.0);
    trace.depth[i] = traces::encode_depth(trace.header.depth_format, depth);
  }
}

bool inside(const Primitive& wedge, double x, double y, double z) {
  if (!(z >= wedge.z.min && z <= wedge.z.max)) return false;
  for (const Plane& plane : wedge.planes) {
    if (!plane.inside(x, y, z)) return false;
  }
  return true;
}

std::int64_t signed_word(const Primitive& wedge, bool polygon_covers, double x, double y,
                         double z) {
  const std::int64_t word =
      to_word(contribution(wedge.terms, x, y, z), word_one(DatapathKind::exact));
  if (!wedge.coverage) return word;
  const bool inner = wedge.polygon ? is_inner(*wedge.polygon, polygon_covers, x, y, z)
                                   : wedge.inner.inside(x, y, z);
  return inner ? word : -word;
}

// Calls f(row, span) for every row of an outline; returns the number of pixels.
template <typename F>
std::uint64_t for_each_row(const Outline& outline, F&& f) {
  std::uint64_t visits = 0;
  const int end = std::min<int>(outline.row_end(), kHeight);
  for (int row = std::max(outline.row_begin(), 0); row < end; ++row) {
    const Span span = outline.row(row, kWidth);
    visits += static_cast<std::uint64_t>(span.end - span.begin);
    f(row, span);
  }
  return visits;
}

void draw_face_row(const Scene& scene, const Primitive& wedge, int row, Span span, Image& image) {
  const auto& polygon = wedge.polygon;
  const bool meets =
      polygon && row >= polygon->outline.row_begin() && row < polygon->outline.row_end();
  const Span umbra = meets ? polygon->outline.row(row, kWidth) : Span{};
  const double y = row + 0.5;
  const std::size_t first = static_cast<std::size_t>(row) * kWidth;
  for (int column = span.begin; column < span.end; ++column) {
    const std::size_t pixel = first + static_cast<std::size_t>(column);
    const double x = column + 0.5;
    const double z = scene.z[pixel];
    if (!inside(wedge, x, y, z)) continue;
    const bool covered = column >= umbra.begin && column < umbra.end;
    image.penumbra[pixel] += signed_word(wedge, covered, x, y, z);
  }
}

void draw_umbra_row(const Scene& scene, const RasterUmbra& polygon, int row, Span span,
                    Image& image) {
  const std::size_t first = static_cast<std::size_t>(row) * kWidth;
  for (int column = span.begin; column < span.end; ++column) {
    const std::size_t pixel = first + static_cast<std::size_t>(column);
    const bool inner = is_inner(polygon, true, column + 0.5, row + 0.5, scene.z[pixel]);
    if (inner == polygon.hits_inner) image.umbra[pixel] += polygon.stencil_step;
  }
}

}  // namespace

Scene::Scene(Light light, Shape shape) {
  std::mt19937 random(kSeed);
  trace = shape == Shape::thin ? test::random_tetrahedra(random, kWidth, kHeight, 2000, 0.01)
                               : test::random_tetrahedra(random, kWidth, kHeight, 64);
  set_depth(trace, shape == Shape::noisy);
  for (auto& wedge : trace.wedges) {
    wedge.mutate_kind(light == Light::linear ? traces::fb::WedgeKind_linear
                                             : traces::fb::WedgeKind_coverage);
  }
  trace.header.lights[0].shape =
      light == Light::sphere ? traces::fb::LightShape_sphere : traces::fb::LightShape_rectangle;
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    wedges.push_back(wedge_primitive(trace.view(), ZMethod::pass, i));
  }
  for (std::uint32_t word : trace.depth) {
    z.push_back(traces::decode_depth(trace.header.depth_format, word));
  }
}

std::uint64_t draw_plainly(const Scene& scene, Image& image) {
  std::uint64_t visits = 0;
  for (const Primitive& wedge : scene.wedges) {
    for (const RasterFace& face : wedge.faces) {
      visits += for_each_row(
          face.outline, [&](int row, Span span) { draw_face_row(scene, wedge, row, span, image); });
    }
    if (!wedge.polygon) continue;
    visits += for_each_row(wedge.polygon->outline, [&](int row, Span span) {
      draw_umbra_row(scene, *wedge.polygon, row, span, image);
    });
  }
  return visits;
}

}  // namespace wedgesim::bench
