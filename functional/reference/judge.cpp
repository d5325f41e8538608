#include "functional/reference/judge.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "functional/methods/light_intensity.h"
#include "functional/raster/spans.h"
#include "functional/reference/judge_coverage.h"
#include "functional/reference/judge_linear.h"
#include "functional/reference/judge_plane.h"
#include "functional/reference/judge_view.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;
// Pixels that each wedge is fetched for.
constexpr std::size_t kBlock = 32;

// What a pixel's stored depth stands for.
struct Point {
  double z = 0.0;         // as the trace compares it with z_min and z_max
  JudgedPlace in_centre;  // relative to the light's centre
  RealVector in_light;
};

struct Umbra {
  JudgedPlane plane;
  fb::UmbraRole role = fb::UmbraRole_side;
  bool eye_facing = false;
  double z_min = 0.0;
  double z_max = 0.0;

  bool inner(const Point& p) const {
    if (p.z < z_min) return !eye_facing;
    if (p.z > z_max) return eye_facing;
    return plane.inside(p.in_centre);
  }
  int share(fb::ZMethod method, const Point& p) const {
    const int fail_sign = eye_facing ? 1 : -1;
    if (role == fb::UmbraRole_cap) return fail_sign;
    const bool passes = inner(p) == eye_facing;
    if (method == fb::ZMethod_pass) return passes ? -fail_sign : 0;
    return passes ? 0 : fail_sign;
  }
};

// Of kind coverage.
struct Wedge {
  JudgedPlane before_end;
  JudgedPlane quad;
  RealVector begin, end;  // light space
  std::uint32_t umbra = traces::kNone;
};
// Its edge in light space, apart from it: of many wedges most are asked for no more.
struct RoundedEdge {
  glm::dvec3 begin, end;
};

class Judge {
 public:
  Judge(const Scene& scene, const Frame& frame, std::span<const std::size_t> pixels)
      : scene_(scene),
        frame_(frame),
        pixels_(pixels),
        method_(frame.trace.header.expected_z_method),
        view_(scene.camera, frame.window.width, frame.window.height),
        light_(scene.light),
        eye_from_centre_(view_.eye() - RealVector(scene.light.centre)),
        umbras_at_(pixels.size()) {
    CHECK_EQ(frame.geometry.umbra_sources.size(), frame.trace.umbra_polygons.size());
    CHECK_EQ(frame.geometry.wedges.size(), frame.trace.wedges.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      ends_.push_back(scene.objects[i].casts ? judged_end(scene, frame, i) : RealPlane());
    }
    for (const LinearLoop& loop : frame.geometry.linear_loops) {
      loops_.emplace_back(scene, loop, ends_[loop.object]);
    }
    for (std::size_t i = 0; i < frame.trace.umbra_polygons.size(); ++i) add_umbra(i);
    find_covered();
    for (std::size_t i = 0; i < frame.trace.wedges.size(); ++i) add_wedge(i);
    for (const BareEdge& edge : frame.geometry.bare_edges) add_edge(edge);
  }

  std::vector<double> run(int depth_step, double* seconds = nullptr) const {
    std::vector<double> li(pixels_.size());
    const std::size_t blocks = (pixels_.size() + kBlock - 1) / kBlock;
    std::vector<std::chrono::duration<double>> spent(blocks);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
      const std::size_t end = std::min(pixels_.size(), (block + 1) * kBlock);
      const auto start = std::chrono::steady_clock::now();
      evaluate(block * kBlock, end, depth_step, li);
      spent[block] = std::chrono::steady_clock::now() - start;
    });
    for (const auto& one : spent) {
      if (seconds != nullptr) *seconds += one.count();
    }
    return li;
  }

 private:
  RealVector from_centre(const EdgeSource& edge, std::uint32_t vertex) const {
    const auto& positions = scene_.objects[edge.object].mesh.positions;
    return RealVector(positions[vertex]) - RealVector(scene_.light.centre);
  }
  JudgedPlane quad_of(const EdgeSource& edge, bool minus) const {
    return {from_centre(edge, edge.begin), from_centre(edge, edge.end), minus};
  }

  JudgedPlane end_of(std::uint32_t object, bool minus, bool turned = false) const {
    const RealPlane& end = ends_[object];
    return {turned ? Real(-1) * end.inward : end.inward, end.through, minus, 1.0};
  }

  JudgedPlane umbra_plane(const UmbraSource& source, bool minus) const {
    EdgeSource edge = source.edge;
    switch (source.plane) {
      case UmbraPlane::none:
        return {};
      case UmbraPlane::quad:
        if (source.turned) std::swap(edge.begin, edge.end);
        return quad_of(edge, minus);
      case UmbraPlane::end:
        return end_of(edge.object, minus, source.turned);
      case UmbraPlane::front:
      case UmbraPlane::near_half:
      case UmbraPlane::far_half:
        break;
    }
    return loops_[edge.loop].umbra_plane(source, minus);
  }

  void add_umbra(std::size_t i) {
    const fb::UmbraPolygon& polygon = frame_.trace.umbra_polygons[i];
    Umbra umbra;
    umbra.plane =
        umbra_plane(frame_.geometry.umbra_sources[i], frame_.geometry.umbra_planes[i].minus);
    umbra.role = polygon.role();
    umbra.z_min = polygon.z_min();
    umbra.z_max = polygon.z_max();
    umbras_.push_back(std::move(umbra));
  }

  // The umbra polygons that count at each of the pixels, and which way they face.
  void find_covered() {
    const auto width = static_cast<std::size_t>(frame_.window.width);
    std::vector<std::uint32_t> place_of(frame_.depth.words.size(), traces::kNone);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      place_of[pixels_[i]] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t u = 0; u < umbras_.size(); ++u) {
      const fb::UmbraPolygon& polygon = frame_.trace.umbra_polygons[u];
      const auto outline = outline_of(frame_.trace, polygon.first_index(), polygon.index_count());
      umbras_[u].eye_facing = doubled_area(outline) < 0;
      if (method_ == fb::ZMethod_pass && umbras_[u].role != fb::UmbraRole_side) continue;
      for_each_span(outline, frame_.window.width, 0, frame_.window.height,
                    [&](int y, int x0, int x1) {
                      for (int x = x0; x < x1; ++x) {
                        const std::size_t pixel =
                            static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                        const std::uint32_t place = place_of[pixel];
                        if (place != traces::kNone) {
                          umbras_at_[place].push_back(static_cast<std::uint32_t>(u));
                        }
                      }
                    });
    }
  }

  void add_wedge(std::size_t i) {
    const ShadowWedge& shadow = frame_.geometry.wedges[i];
    add_edge({shadow.source, shadow.umbra_plane, shadow.planes, frame_.trace.wedges[i].umbra()});
  }
  void add_edge(const BareEdge& bare) {
    if (frame_.geometry.kind == fb::WedgeKind_linear) {
      linear_wedges_.push_back(loops_[bare.source.loop].wedge(bare.source.place, bare.planes));
      return;
    }
    Wedge wedge;
    wedge.umbra = bare.umbra;
    wedge.before_end = end_of(bare.source.object, bare.planes.back().minus);
    wedge.quad = quad_of(bare.source, bare.umbra_plane.minus);
    wedge.begin = light_(from_centre(bare.source, bare.source.begin));
    wedge.end = light_(from_centre(bare.source, bare.source.end));
    edges_.push_back({to_double(wedge.begin), to_double(wedge.end)});
    wedges_.push_back(std::move(wedge));
  }

  Point point_at(std::size_t pixel, int depth_step) const {
    const fb::DepthFormat format = frame_.depth.format;
    const std::uint32_t word = traces::step_depth(format, frame_.depth.words[pixel], depth_step);
    const RealVector from_eye = view_.from_eye(pixel, judged_depth(format, word));
    const RealVector centre = eye_from_centre_ + from_eye;
    const double reach = magnitude(from_eye);
    Point point;
    point.z = traces::decode_depth(format, word);
    point.in_centre = {centre, magnitude(eye_from_centre_) + reach};
    point.in_light = light_(centre);
    return point;
  }

  struct Sum {
    Point point;
    const std::vector<std::uint32_t>* covering;
    CoverageFilter filter;
    Real li = 1;
  };

  void evaluate(std::size_t begin, std::size_t end, int depth_step, std::vector<double>& li) const {
    std::vector<Sum> sums;
    for (std::size_t i = begin; i < end; ++i) {
      const Point point = point_at(pixels_[i], depth_step);
      sums.push_back({point, &umbras_at_[i], {scene_.light.shape, point.in_light}});
      for (const std::uint32_t u : umbras_at_[i]) {
        sums.back().li += umbras_[u].share(method_, point);
      }
    }
    for (const JudgedWedge& wedge : linear_wedges_) {
      for (Sum& sum : sums) sum.li += wedge.share(sum.point.in_centre);
    }
    for (std::size_t w = 0; w < wedges_.size(); ++w) {
      for (Sum& sum : sums) {
        if (sum.filter.may_cover(edges_[w].begin, edges_[w].end)) {
          sum.li += coverage_share(wedges_[w], sum.point, *sum.covering);
        }
      }
    }
    for (std::size_t i = begin; i < end; ++i) li[i] = sums[i - begin].li.convert_to<double>();
  }

  Real coverage_share(const Wedge& wedge, const Point& point,
                      const std::vector<std::uint32_t>& covering) const {
    if (!wedge.before_end.inside(point.in_centre)) return 0;
    const Real covered =
        judged_coverage(scene_.light.shape, point.in_light, wedge.begin, wedge.end);
    if (covered == 0) return 0;
    const bool by_polygon = wedge.umbra != traces::kNone &&
                            std::binary_search(covering.begin(), covering.end(), wedge.umbra);
    const bool inner =
        by_polygon ? umbras_[wedge.umbra].inner(point) : wedge.quad.inside(point.in_centre);
    return inner ? covered : Real(-covered);
  }

  const Scene& scene_;
  const Frame& frame_;
  std::span<const std::size_t> pixels_;
  fb::ZMethod method_;
  JudgedView view_;
  JudgedLight light_;
  RealVector eye_from_centre_;
  std::vector<RealPlane> ends_;  // of each object
  std::vector<JudgedLoop> loops_;
  std::vector<Umbra> umbras_;
  std::vector<Wedge> wedges_;
  std::vector<RoundedEdge> edges_;  // of each of wedges_
  std::vector<JudgedWedge> linear_wedges_;
  std::vector<std::vector<std::uint32_t>> umbras_at_;  // each of pixels_: in order
};

}  // namespace

std::vector<double> judge_light_intensity(const Scene& scene, const Frame& frame,
                                          std::span<const std::size_t> pixels, int depth_step,
                                          double* seconds) {
  return Judge(scene, frame, pixels).run(depth_step, seconds);
}

Judgement judge_with_sensitivity(const Scene& scene, const Frame& frame,
                                 std::span<const std::size_t> pixels) {
  const Judge judge(scene, frame, pixels);
  Judgement judged{judge.run(0), {}};
  const std::vector<double> nearer = judge.run(-1);
  const std::vector<double> farther = judge.run(1);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double li = judged.li[i];
    judged.sensitivity.push_back(std::max(std::abs(nearer[i] - li), std::abs(farther[i] - li)));
  }
  return judged;
}

}  // namespace wedgesim::functional
