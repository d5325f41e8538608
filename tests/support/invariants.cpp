#include "tests/support/invariants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "functional/methods/brute_force.h"
#include "functional/methods/light_intensity.h"
#include "functional/raster/depth_buffer.h"
#include "model/count/contribution.h"
#include "model/count/count.h"

namespace wedgesim::tests {
namespace {

namespace fb = traces::fb;
using namespace model;  // NOLINT: the vocabulary of configurations
using functional::DepthBuffer;
using functional::Frame;

std::vector<CountConfig> configurations(ZChoice z, bool all) {
  std::vector<CountConfig> configs;
  if (all) {
    for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
      for (unsigned tile = 2; tile <= 256; tile *= 2) {
        for (const Cull cull :
             {Cull::none, Cull::zmax, Cull::zrange, Cull::planes, Cull::both, Cull::sat}) {
          for (const UmbraCull umbra : {UmbraCull::none, UmbraCull::zmax}) {
            for (const Accept accept : {Accept::none, Accept::zmin}) {
              for (const Share share : {Share::eye, Share::all}) {
                configs.push_back({mode, tile, cull, umbra, accept, share, z, TileBuild::eager});
              }
            }
          }
        }
      }
    }
    return configs;
  }
  configs.push_back(
      {Mode::three_pass, 8, Cull::none, UmbraCull::none, Accept::none, Share::eye, z});
  unsigned tile = 2;
  for (const Cull cull : {Cull::zmax, Cull::zrange, Cull::planes, Cull::both, Cull::sat}) {
    configs.push_back(
        {Mode::single_pass, tile, cull, UmbraCull::zmax, Accept::zmin, Share::all, z});
    configs.push_back(
        {Mode::three_pass, 2 * tile, cull, UmbraCull::zmax, Accept::zmin, Share::eye, z});
    tile *= 2;
  }
  return configs;
}

std::uint64_t visits_culled(const Counters& c) {
  return c.visits_culled_zmax.value() + c.visits_culled_zrange.value() +
         c.visits_culled_planes.value() + c.visits_culled_sat.value() +
         c.umbra_visits_culled.value();
}

}  // namespace

std::string check_words(const Frame& frame, const Datapath& datapath, ZChoice z, bool all,
                        std::vector<std::int64_t>& words) {
  const traces::TraceView view = frame.trace.view();
  const std::vector<CountConfig> configs = configurations(z, all);
  CountOptions options;
  options.datapath = datapath;
  options.maps = true;
  options.threads = 2;
  const std::vector<CountResult> results = count(view, configs, options);
  words = results.front().li;
  std::map<unsigned, std::uint64_t> needless;  // by tile size
  std::map<std::pair<unsigned, Cull>, std::uint64_t> penumbra_reads;
  std::map<std::tuple<unsigned, UmbraCull, Accept>, std::uint64_t> umbra_reads;  // unshared
  for (const CountResult& result : results) {
    const CountConfig& c = result.config;
    const auto place =
        fmt::format("{} tile {} cull {} umbra {} accept {} share {} z {}", spelling(c.mode), c.tile,
                    spelling(c.cull), spelling(c.umbra_cull), spelling(c.accept), spelling(c.share),
                    spelling(c.z));
    if (result.wrong_contributions != 0) {
      return fmt::format("{} contributions lost or gained: {}", result.wrong_contributions, place);
    }
    if (result.li != words) return "LI words differ: " + place;
    if (visits_culled(*result.counters) > result.needless_visits) {
      return "more visits culled than are needless: " + place;
    }
    if (needless.emplace(c.tile, result.needless_visits).first->second != result.needless_visits) {
      return "needless visits differ: " + place;
    }
    const std::uint64_t reads = result.counters->z_reads.value();
    const std::uint64_t penumbra = result.penumbra_z_reads;
    if (penumbra > reads ||
        penumbra_reads.emplace(std::pair(c.tile, c.cull), penumbra).first->second != penumbra) {
      return "z reads of penumbrae differ: " + place;
    }
    const auto umbra = std::tuple(c.tile, c.umbra_cull, c.accept);
    if (c.mode == Mode::three_pass &&
        umbra_reads.emplace(umbra, reads - penumbra).first->second != reads - penumbra) {
      return "z reads of umbra polygons differ: " + place;
    }
    if (datapath.kind != DatapathKind::float32 && result.pixels.mismatched != 0) {
      const PixelError& worst = result.pixels.worst.front();
      return fmt::format("{} pixels mismatch, worst ({}, {}) expected {} is {} sensitivity {}: {}",
                         result.pixels.mismatched, worst.x, worst.y, worst.expected, worst.li,
                         worst.sensitivity, place);
    }
  }
  options.threads = 1;
  options.kernel = KernelChoice::scalar;
  if (count(view, std::span(configs).first(1), options).front().li != words) {
    return "LI words differ between kernels or thread counts";
  }
  return {};
}

namespace {

bool is_sky(const Frame& frame, std::size_t pixel) {
  return frame.depth.triangle[pixel] == DepthBuffer::kSky;
}

glm::dvec3 point_of(const Frame& frame, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(frame.window.width);
  return functional::world_point(
      frame.window, static_cast<double>(pixel % width) + 0.5,
      static_cast<double>(pixel / width) + 0.5,
      traces::decode_depth(frame.depth.format, frame.depth.words[pixel]));
}

std::string check_integers(const functional::Scene& scene, const Frame& frame,
                           const std::vector<std::int64_t>& words) {
  const auto one = static_cast<std::int64_t>(word_one(DatapathKind::exact));
  for (std::size_t pixel = 0; pixel < words.size(); ++pixel) {
    if (is_sky(frame, pixel)) continue;
    // On a caster rounding of z may put a point beyond the far side of its own volume, whose cap,
    // the caster, it never passed: k = -1 there, and light where light is.
    const bool on_caster = scene.objects[frame.depth.surface(pixel).object].casts;
    if (words[pixel] % one == 0 && (on_caster || words[pixel] <= one)) continue;
    const glm::dvec3 p = point_of(frame, pixel);
    const bool in_wedge = std::any_of(
        frame.geometry.wedges.begin(), frame.geometry.wedges.end(), [&](const auto& wedge) {
          return std::all_of(wedge.planes.begin(), wedge.planes.end(),
                             [&](const auto& plane) { return plane.inside(p); });
        });
    if (!in_wedge) {
      return fmt::format("pixel {} is outside every wedge and has the word {}", pixel,
                         words[pixel]);
    }
  }
  return {};
}

std::string check_degrees(const functional::Scene& scene) {
  for (const functional::Object& object : scene.objects) {
    if (!object.casts) continue;
    std::map<std::uint32_t, int> degree;
    const auto silhouette = functional::find_silhouette(object.mesh, scene.light.centre);
    for (const auto& loop : silhouette.loops) {
      for (const auto& edge : loop) {
        ++degree[edge.begin];
        ++degree[edge.end];
      }
    }
    for (const auto& [vertex, edges] : degree) {
      if (edges % 2 != 0) return fmt::format("vertex {} has degree {}", vertex, edges);
    }
  }
  return {};
}

// Distance in pixels from a pixel centre to the nearest edge of any umbra polygon.
double distance_to_umbra_edge(const Frame& frame, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(frame.window.width);
  const glm::dvec2 p(static_cast<double>(pixel % width) + 0.5,
                     static_cast<double>(pixel / width) + 0.5);
  double nearest = 1e300;
  const auto& trace = frame.trace;
  for (const fb::UmbraPolygon& polygon : trace.umbra_polygons) {
    for (std::uint32_t i = 0; i < polygon.index_count(); ++i) {
      const auto corner = [&](std::uint32_t k) {
        const fb::ScreenVertex& v =
            trace.vertices[trace.indices[polygon.first_index() + k % polygon.index_count()]];
        return glm::dvec2(v.x(), v.y()) / 256.0;
      };
      const glm::dvec2 a = corner(i);
      const glm::dvec2 way = corner(i + 1) - a;
      const double length = glm::dot(way, way);
      const double t = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
      nearest = std::min(nearest, glm::distance(p, a + t * way));
    }
  }
  return nearest;
}

std::string check_witness(const functional::Scene& scene, const Frame& frame,
                          std::size_t& differing) {
  // Every pixel where that is quick, else evenly fewer.
  constexpr double kMostTests = 2e7;
  const double tests =
      static_cast<double>(frame.depth.words.size()) *
      static_cast<double>(frame.geometry.caps.size() + frame.geometry.wedges.size());
  const auto stride = static_cast<std::size_t>(1.0 + tests / kMostTests);
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < frame.depth.words.size(); i += stride) {
    if (!is_sky(frame, i) && !scene.objects[frame.depth.surface(i).object].casts) {
      pixels.push_back(i);
    }
  }
  const std::vector<double> li = functional::brute_force_light_intensity(
      scene, frame.window, frame.depth, frame.geometry, pixels);
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const std::size_t pixel = pixels[k];
    const double expected = frame.trace.expected_li[pixel];
    const double allowed = 1e-6 + static_cast<double>(frame.trace.li_sensitivity[pixel]);
    if (std::abs(li[k] - expected) <= allowed) continue;
    ++differing;
    if (distance_to_umbra_edge(frame, pixel) > 1.0 / 64.0) {
      return fmt::format("pixel {} has LI {}, by brute force {}, far from any umbra edge", pixel,
                         expected, li[k]);
    }
  }
  return {};
}

}  // namespace

InvariantReport check_invariants(const functional::Scene& scene,
                                 const functional::FrameOptions& options, bool every_config) {
  const Frame frame = functional::make_frame(scene, options);
  InvariantReport report;
  report.z_fail = frame.trace.header.z_fail_needed;
  report.wedges = frame.trace.wedges.size();
  const bool coverage = options.kind == fb::WedgeKind_coverage;

  std::vector<std::int64_t> words;
  report.failure = check_words(frame, DatapathKind::exact, ZChoice::automatic, every_config, words);
  if (report.failure.empty() && coverage && !report.z_fail) {
    std::vector<std::int64_t> fail_words;
    report.failure =
        check_words(frame, DatapathKind::exact, ZChoice::fail, every_config, fail_words);
    for (std::size_t i = 0; report.failure.empty() && i < words.size(); ++i) {
      if (!is_sky(frame, i) && words[i] != fail_words[i]) {
        report.failure = fmt::format("pixel {}: z-pass {} z-fail {}", i, words[i], fail_words[i]);
      }
    }
  }
  if (report.failure.empty() && coverage) report.failure = check_integers(scene, frame, words);
  if (report.failure.empty()) report.failure = check_degrees(scene);
  if (report.failure.empty() && (coverage || !report.z_fail)) {
    report.failure = check_witness(scene, frame, report.witness_pixels);
  }
  return report;
}

}  // namespace wedgesim::tests
