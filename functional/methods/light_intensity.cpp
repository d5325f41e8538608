#include "functional/methods/light_intensity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "functional/geometry/hull.h"
#include "functional/light/coverage.h"
#include "functional/raster/spans.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;
constexpr int kBandRows = 16;
constexpr std::size_t kDepths = 3;  // stored z, one step nearer, one step farther

struct Row {
  int begin = 0;
  int end = 0;
};
using BandRows = std::array<Row, kBandRows>;

// Rows that an outline may touch.
struct Extent {
  int y_begin = 0;
  int y_end = 0;
};

Extent extent_of(const std::vector<SnappedPoint>& outline) {
  if (outline.empty()) return {};
  const auto [low, high] = std::minmax_element(
      outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return {(low->y >> 8) - 1, (high->y >> 8) + 2};
}

BandRows rows_of(const std::vector<SnappedPoint>& outline, int width, int y_begin, int y_end) {
  BandRows rows{};
  for_each_span(outline, width, y_begin, y_end, [&](int y, int x0, int x1) {
    rows[static_cast<std::size_t>(y - y_begin)] = {x0, x1};
  });
  return rows;
}

struct UmbraPolygon {
  std::vector<SnappedPoint> outline;
  Extent extent;
  SidedPlane plane;
  fb::UmbraRole role = fb::UmbraRole_side;
  bool eye_facing = false;
  double z_min = 0.0;
  double z_max = 0.0;

  // Whether a point is on the shadow's side: by its depth where that decides, else by the plane.
  bool inner(const glm::dvec3& world, double z) const {
    if (z < z_min) return !eye_facing;
    if (z > z_max) return eye_facing;
    return plane.inside(world);
  }
  // Paper II, 3 and 5: what the polygon adds at a pixel it covers.
  double share(fb::ZMethod method, const glm::dvec3& world, double z) const {
    const double fail_sign = eye_facing ? 1.0 : -1.0;
    if (role == fb::UmbraRole_cap) return fail_sign;
    const bool passes = inner(world, z) == eye_facing;
    if (method == fb::ZMethod_pass) return passes ? -fail_sign : 0.0;
    return passes ? 0.0 : fail_sign;
  }
};

class Evaluation {
 public:
  Evaluation(const Scene& scene, const Window& window, const DepthBuffer& depth,
             const ShadowGeometry& geometry, const traces::Trace& trace, fb::ZMethod method)
      : light_(scene.light),
        to_light_(light_from_world(scene.light)),
        window_(window),
        depth_(depth),
        geometry_(geometry),
        trace_(trace),
        method_(method) {
    for (std::size_t i = 0; i < trace.umbra_polygons.size(); ++i) {
      const fb::UmbraPolygon& p = trace.umbra_polygons[i];
      UmbraPolygon polygon;
      polygon.outline = outline_of(trace, p.first_index(), p.index_count());
      polygon.extent = extent_of(polygon.outline);
      polygon.plane = geometry.umbra_planes[i];
      polygon.role = p.role();
      polygon.eye_facing = doubled_area(polygon.outline) < 0;
      polygon.z_min = p.z_min();
      polygon.z_max = p.z_max();
      umbra_.push_back(std::move(polygon));
    }
    for (const fb::Wedge& wedge : trace.wedges) hulls_.push_back(hull_of(wedge));
    for (const auto& hull : hulls_) hull_extents_.push_back(extent_of(hull));
  }

  LightIntensity run() const {
    LightIntensity result;
    const std::size_t pixels = depth_.words.size();
    result.li.resize(pixels);
    result.sensitivity.resize(pixels);
    const int bands = (window_.height + kBandRows - 1) / kBandRows;
    tbb::parallel_for(0, bands, [&](int band) { evaluate_band(band * kBandRows, result); });
    return result;
  }

 private:
  struct Points {
    std::array<glm::dvec3, kDepths> world;
    std::array<glm::dvec3, kDepths> in_light;
    std::array<double, kDepths> z;
    std::array<double, kDepths> li{1.0, 1.0, 1.0};
  };

  // The convex outline around all faces of a wedge on the screen.
  std::vector<SnappedPoint> hull_of(const fb::Wedge& wedge) const {
    std::vector<glm::dvec2> points;
    for (std::uint32_t f = wedge.first_face(); f < wedge.first_face() + wedge.face_count(); ++f) {
      const fb::Face& face = trace_.faces[f];
      for (const SnappedPoint& p : outline_of(trace_, face.first_index(), face.index_count())) {
        points.emplace_back(p.x, p.y);
      }
    }
    std::vector<SnappedPoint> hull;
    for (const glm::dvec2& p : convex_hull(points)) {
      hull.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y), 0.0});
    }
    return hull;
  }

  void evaluate_band(int y_begin, LightIntensity& result) const {
    const int y_end = std::min(window_.height, y_begin + kBandRows);
    const auto width = static_cast<std::size_t>(window_.width);
    const std::size_t first = static_cast<std::size_t>(y_begin) * width;
    std::vector<Points> points(static_cast<std::size_t>(y_end - y_begin) * width);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = static_cast<double>(i % width) + 0.5;
      const double y = static_cast<double>(y_begin) + static_cast<double>(i / width) + 0.5;
      for (std::size_t k = 0; k < kDepths; ++k) {
        const int step = k == 0 ? 0 : (k == 1 ? -1 : 1);
        Points& p = points[i];
        p.z[k] = traces::decode_depth(
            depth_.format, traces::step_depth(depth_.format, depth_.words[first + i], step));
        p.world[k] = world_point(window_, x, y, p.z[k]);
        p.in_light[k] = glm::dvec3(to_light_ * glm::dvec4(p.world[k], 1.0));
      }
    }
    for (const UmbraPolygon& polygon : umbra_) {
      if (method_ == fb::ZMethod_pass && polygon.role != fb::UmbraRole_side) continue;
      if (polygon.extent.y_begin >= y_end || polygon.extent.y_end <= y_begin) continue;
      for_each_span(polygon.outline, window_.width, y_begin, y_end, [&](int y, int x0, int x1) {
        for (int x = x0; x < x1; ++x) {
          Points& p =
              points[static_cast<std::size_t>(y - y_begin) * width + static_cast<std::size_t>(x)];
          for (std::size_t k = 0; k < kDepths; ++k) {
            p.li[k] += polygon.share(method_, p.world[k], p.z[k]);
          }
        }
      });
    }
    for (std::size_t w = 0; w < hulls_.size(); ++w) {
      if (hull_extents_[w].y_begin >= y_end || hull_extents_[w].y_end <= y_begin) continue;
      add_wedge(w, y_begin, y_end, points);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& li = points[i].li;
      result.li[first + i] = li[0];
      const double change = std::max(std::abs(li[1] - li[0]), std::abs(li[2] - li[0]));
      result.sensitivity[first + i] = static_cast<float>(change);
    }
  }

  void add_wedge(std::size_t w, int y_begin, int y_end, std::vector<Points>& points) const {
    const ShadowWedge& wedge = geometry_.wedges[w];
    const fb::Wedge& record = trace_.wedges[w];
    const UmbraPolygon* umbra = record.umbra() == traces::kNone ? nullptr : &umbra_[record.umbra()];
    const BandRows umbra_rows =
        umbra != nullptr ? rows_of(umbra->outline, window_.width, y_begin, y_end) : BandRows{};
    for_each_span(hulls_[w], window_.width, y_begin, y_end, [&](int y, int x0, int x1) {
      const Row row = umbra_rows[static_cast<std::size_t>(y - y_begin)];
      for (int x = x0; x < x1; ++x) {
        Points& p =
            points[static_cast<std::size_t>(y - y_begin) * static_cast<std::size_t>(window_.width) +
                   static_cast<std::size_t>(x)];
        const bool covered = x >= row.begin && x < row.end;
        for (std::size_t k = 0; k < kDepths; ++k) {
          if (p.z[k] < record.z_min() || p.z[k] > record.z_max()) continue;
          const bool inside =
              std::all_of(wedge.planes.begin(), wedge.planes.end(),
                          [&](const SidedPlane& plane) { return plane.inside(p.world[k]); });
          if (!inside) continue;
          const bool inner =
              covered ? umbra->inner(p.world[k], p.z[k]) : wedge.umbra_plane.inside(p.world[k]);
          p.li[k] +=
              penumbra_share(light_, geometry_.kind, wedge, p.world[k], p.in_light[k], inner);
        }
      }
    });
  }

  const Light& light_;
  glm::dmat4 to_light_;
  const Window& window_;
  const DepthBuffer& depth_;
  const ShadowGeometry& geometry_;
  const traces::Trace& trace_;
  fb::ZMethod method_;
  std::vector<UmbraPolygon> umbra_;
  std::vector<std::vector<SnappedPoint>> hulls_;
  std::vector<Extent> hull_extents_;
};

// Paper I, Eqs. 2 and 3.
double linear_intensity(const ShadowWedge& wedge, const glm::dvec3& p) {
  const auto distance = [&](std::size_t plane, std::size_t factor) {
    const glm::dvec4& n = wedge.planes[plane].plane;
    return std::abs(glm::dot(glm::dvec3(n), p) + n.w) * wedge.factors[factor];
  };
  const auto ratio = [](double a, double b) { return a + b > 0.0 ? a / (a + b) : 0.5; };
  const double s_left = ratio(distance(1, 1), distance(0, 0));
  const double s_right = ratio(distance(1, 3), distance(0, 2));
  const double to_left = distance(2, 4);
  const double to_right = distance(3, 5);
  const double share = ratio(to_right, to_left);
  return share * s_left + (1.0 - share) * s_right;
}

}  // namespace

std::vector<SnappedPoint> outline_of(const traces::Trace& trace, std::uint32_t first,
                                     std::uint32_t count) {
  std::vector<SnappedPoint> outline;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const fb::ScreenVertex& v = trace.vertices[trace.indices[i]];
    outline.push_back({v.x(), v.y(), v.z()});
  }
  return outline;
}

double penumbra_share(const Light& light, fb::WedgeKind kind, const ShadowWedge& wedge,
                      const glm::dvec3& world, const glm::dvec3& in_light, bool inner) {
  if (kind == fb::WedgeKind_linear) return linear_intensity(wedge, world);
  const double covered = coverage(light.shape, in_light, wedge.light_begin, wedge.light_end);
  return inner ? covered : -covered;
}

LightIntensity evaluate_light_intensity(const Scene& scene, const Window& window,
                                        const DepthBuffer& depth, const ShadowGeometry& geometry,
                                        const traces::Trace& trace, fb::ZMethod method) {
  return Evaluation(scene, window, depth, geometry, trace, method).run();
}

}  // namespace wedgesim::functional
