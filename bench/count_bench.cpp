// Pixel visits per second of one thread: rasterize a wedge, test the depth of every pixel that its
// faces cover, evaluate and add the contributions. The plain loop is the baseline that the SIMD
// kernels are held against; both give the same LI words, which is checked before timing.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "model/count/footprint.h"
#include "model/count/light_image.h"
#include "tests/model/count/synthetic.h"
#include "traces/depth.h"

namespace wedgesim::model {
namespace {

constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 427;

enum class Workload { linear, rectangle, sphere };

// Wedges of many sizes in front of, in and behind a floor that rises towards a wall.
struct Scene {
  explicit Scene(Workload workload) {
    std::mt19937 random(2002);
    trace = test::random_tetrahedra(random, kWidth, kHeight, 64);
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
      const double up = 1.0 - static_cast<double>(i / kWidth) / kHeight;
      const double depth = std::min(0.3 + 0.4 * up, 0.55);
      trace.depth[i] = traces::encode_depth(trace.header.depth_format, depth);
    }
    for (auto& wedge : trace.wedges) {
      wedge.mutate_kind(workload == Workload::linear ? traces::fb::WedgeKind_linear
                                                     : traces::fb::WedgeKind_coverage);
    }
    trace.header.lights[0].shape = workload == Workload::sphere ? traces::fb::LightShape_sphere
                                                                : traces::fb::LightShape_rectangle;
    for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
      wedges.push_back(wedge_primitive(trace.view(), ZMethod::pass, i));
    }
    for (std::uint32_t word : trace.depth) {
      z.push_back(traces::decode_depth(trace.header.depth_format, word));
    }
  }

  traces::Trace trace;
  std::vector<Primitive> wedges;
  std::vector<double> z;  // (height, width)
};

bool inside(const Primitive& wedge, double x, double y, double z) {
  if (!(z >= wedge.z.min && z <= wedge.z.max)) return false;
  for (const Plane& plane : wedge.planes) {
    if (!plane.inside(x, y, z)) return false;
  }
  return true;
}

std::int64_t signed_word(const Primitive& wedge, bool polygon_covers, double x, double y,
                         double z) {
  const std::int64_t word = to_word(contribution(wedge.terms, x, y, z), word_one(LiFormat::exact));
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

struct Image {
  explicit Image(std::size_t pixels) : penumbra(pixels), umbra(pixels) {}
  std::vector<std::int64_t> penumbra;
  std::vector<std::int32_t> umbra;
};

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

// The plain loop: polygons, rows, pixels. \return pixel visits
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

// The counter's own path, by one kernel.
void draw_by_kernel(const Scene& scene, const ZFrame& frame, const Kernel& kernel,
                    LightImage& image) {
  Footprint footprint;
  for (const Primitive& wedge : scene.wedges) {
    for (int band = 0; band * kBandRows < frame.height(); ++band) {
      footprint.build(wedge, frame, band, kernel);
      image.add(wedge, footprint, frame, kernel, word_one(LiFormat::exact));
    }
  }
}

std::uint64_t check(const Scene& scene, const Kernel& kernel) {
  Image plain(scene.z.size());
  const std::uint64_t visits = draw_plainly(scene, plain);
  const ZFrame frame(scene.trace.view());
  LightImage image(frame);
  draw_by_kernel(scene, frame, kernel, image);
  frame.for_each_block([&](std::uint32_t bx, std::uint32_t by) {
    std::array<std::int64_t, kBlockPixels> penumbra;
    std::array<std::int32_t, kBlockPixels> umbra;
    std::array<std::uint32_t, kBlockPixels> contributions;
    image.sums(frame.block(bx, by), penumbra.data(), umbra.data(), contributions.data());
    for (std::uint32_t bit = 0; bit < kBlockPixels; ++bit) {
      const std::uint32_t x = bx * kBlock + bit % kBlock;
      const std::uint32_t y = by * kBlock + bit / kBlock;
      if (x >= kWidth || y >= kHeight) continue;
      const std::size_t pixel = std::size_t{y} * kWidth + x;
      if (penumbra[bit] != plain.penumbra[pixel] || umbra[bit] != plain.umbra[pixel]) {
        std::fprintf(stderr, "%s differs from the plain loop at %u,%u\n", kernel.name, x, y);
        std::exit(1);
      }
    }
  });
  return visits;
}

void report(benchmark::State& state, std::uint64_t visits) {
  state.counters["visits"] = benchmark::Counter(
      static_cast<double>(visits * static_cast<std::uint64_t>(state.iterations())),
      benchmark::Counter::kIsRate);
}

void plain(benchmark::State& state, Workload workload) {
  const Scene scene(workload);
  Image image(scene.z.size());
  std::uint64_t visits = 0;
  for (auto _ : state) visits = draw_plainly(scene, image);
  report(state, visits);
}

void by_kernel(benchmark::State& state, Workload workload, const Kernel& kernel) {
  const Scene scene(workload);
  const std::uint64_t visits = check(scene, kernel);
  const ZFrame frame(scene.trace.view());
  LightImage image(frame);
  for (auto _ : state) draw_by_kernel(scene, frame, kernel, image);
  report(state, visits);
}

void register_all() {
  const std::pair<const char*, Workload> workloads[] = {{"linear", Workload::linear},
                                                        {"rectangle", Workload::rectangle},
                                                        {"sphere", Workload::sphere}};
  for (const auto& [name, workload] : workloads) {
    const std::string prefix = std::string(name) + "/";
    benchmark::RegisterBenchmark((prefix + "plain").c_str(), plain, workload);
    for (const Kernel& kernel : simd_kernels()) {
      benchmark::RegisterBenchmark((prefix + kernel.name).c_str(), by_kernel, workload, kernel);
    }
  }
}

}  // namespace
}  // namespace wedgesim::model

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  wedgesim::model::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
