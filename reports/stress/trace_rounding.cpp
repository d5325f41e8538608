#include "reports/stress/trace_rounding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/count/operands.h"
#include "reports/stress/light_rounding.h"
#include "reports/stress/linear_rounding.h"
#include "reports/stress/world.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

using model::Primitive;

// Of a plane made in double precision from a scene, and of its value: half units in the last place
// of its terms, of which it is a sum of products of sums.
constexpr double kRoundings = 32.0;

struct Pixel {
  int column = 0, row = 0;
  double x = 0.0, y = 0.0, z = 0.0;  // window: its centre, pixels, and its depth
  double per_distance = 0.0;         // 1 / the distance of view
  double way = 0.0;                  // the point's distance from the eye times per_distance
};

class Rounding {
 public:
  explicit Rounding(const traces::TraceView& trace) : trace_(trace), linear_(trace) {
    const traces::Camera& camera = trace.header.camera;
    const glm::dvec3 eye(camera.eye.x(), camera.eye.y(), camera.eye.z());
    const std::uint32_t width = trace.header.width;
    for (std::uint32_t i = 0; i < trace.depth.size(); ++i) {
      Pixel p{static_cast<int>(i % width), static_cast<int>(i / width)};
      p.x = p.column + 0.5;
      p.y = p.row + 0.5;
      p.z = traces::decode_depth(trace.header.depth_format, trace.depth[i]);
      const glm::dvec4 point = world_point(trace, p.x, p.y, p.z);
      p.per_distance = point.w;
      p.way = glm::length(glm::dvec3(point) - p.per_distance * eye);
      pixels_.push_back(p);
    }
  }

  TraceRounding operator()(std::uint32_t number, const Primitive& primitive) const {
    return {number, is_uncertain(primitive), moved(primitive)};
  }

 private:
  // LI jumps across an umbra polygon's plane, and across those of a `linear` wedge.
  bool is_uncertain(const Primitive& primitive) const {
    const model::RasterUmbra* umbra = primitive.polygon ? &*primitive.polygon : nullptr;
    if (umbra != nullptr && umbra->cap) return false;
    const bool linear = primitive.wedge && !primitive.coverage;
    return std::ranges::any_of(pixels_, [&](const Pixel& p) {
      const bool here = (umbra != nullptr && umbra->outline.covers(p.column, p.row)) ||
                        (primitive.wedge && primitive.faces_cover(p.column, p.row));
      if (!here) return false;
      if (may_err(primitive.wedge ? primitive.inner : umbra->inner, p)) return true;
      return linear && std::ranges::any_of(primitive.planes, [&](const model::Plane& plane) {
               return may_err(plane, p);
             });
    });
  }

  // Whether a plane's value at a pixel is within what rounding in double precision explains: of its
  // terms in the window, and of those that it was made from in the world. World planes go through
  // the light of their wedge.
  bool may_err(const model::Plane& plane, const Pixel& p) const {
    const double window = std::fabs(plane.a) * trace_.header.width +
                          std::fabs(plane.b) * trace_.header.height + std::fabs(plane.c) +
                          std::fabs(plane.d);
    const double value = ((plane.a * p.x + plane.b * p.y) + plane.c * p.z) + plane.d;
    const glm::dvec3 normal(world_plane(trace_, {plane.a, plane.b, plane.c, plane.d}));
    const double world = glm::length(normal) * (from_light_ * p.per_distance + p.way);
    return std::fabs(value) <= kRoundings * 0x1p-53 * (window + world);
  }

  double moved(const Primitive& primitive) const {
    if (!primitive.wedge) return 0.0;
    const traces::fb::Wedge& wedge = trace_.wedges[*primitive.wedge];
    double worst = 0.0;
    for (const Pixel& p : pixels_) {
      if (!primitive.faces_cover(p.column, p.row)) continue;
      if (p.z < primitive.z.min || p.z > primitive.z.max) continue;
      const double here = primitive.coverage ? light_rounding(trace_, wedge, p.x, p.y, p.z)
                                             : linear_(*primitive.wedge, p.x, p.y, p.z);
      if (!(here <= worst)) worst = std::isnan(here) ? 1.0 : here;
    }
    return worst;
  }

  double farthest_light() const {
    const traces::fb::Vec3& eye = trace_.header.camera.eye;
    double farthest = 0.0;
    for (const traces::Light& light : trace_.header.lights) {
      farthest =
          std::max(farthest, std::hypot(light.centre.x() - eye.x(), light.centre.y() - eye.y(),
                                        light.centre.z() - eye.z()));
    }
    return farthest;
  }

  const traces::TraceView& trace_;
  LinearRounding linear_;
  std::vector<Pixel> pixels_;
  double from_light_ = farthest_light();  // the eye
};

}  // namespace

std::vector<TraceRounding> trace_roundings(const traces::TraceView& trace, model::ZMethod method) {
  const Rounding rounding(trace);
  const model::Operands operands(trace);
  const auto count = static_cast<std::uint32_t>(trace.wedges.size());
  std::vector<TraceRounding> all;
  for (std::uint32_t w = 0; w < count; ++w) {
    all.push_back(rounding(w, model::wedge_primitive(operands, method, w)));
  }
  for (const std::uint32_t i : model::lone_polygons(trace, method)) {
    all.push_back(rounding(count + i, model::lone_primitive(operands, method, i)));
  }
  return all;
}

}  // namespace wedgesim::reports::stress
