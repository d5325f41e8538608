#include "model/units/primitive_setup.h"

#include <algorithm>
#include <limits>

namespace wedgesim::model::units {
namespace {

struct Corner {
  std::int64_t x, y;
};

// The first pixel whose centre is at or beyond a coordinate.
std::int64_t first_pixel(std::int64_t coordinate) { return (coordinate + 127) >> 8; }

PixelBox bounds_of(const std::vector<Corner>& corners, int width, int height) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  std::int64_t x0 = kFar, y0 = kFar, x1 = -kFar, y1 = -kFar;
  for (const Corner& corner : corners) {
    x0 = std::min(x0, corner.x);
    x1 = std::max(x1, corner.x);
    y0 = std::min(y0, corner.y);
    y1 = std::max(y1, corner.y);
  }
  const auto clip = [](std::int64_t value, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>(value, 0, limit));
  };
  return {clip(first_pixel(x0), width), clip(first_pixel(y0), height),
          clip(first_pixel(x1 + 1), width), clip(first_pixel(y1 + 1), height)};
}

void extend(PixelBox& box, const PixelBox& other) {
  if (other.empty()) return;
  if (box.empty()) {
    box = other;
    return;
  }
  box = {std::min(box.x0, other.x0), std::min(box.y0, other.y0), std::max(box.x1, other.x1),
         std::max(box.y1, other.y1)};
}

}  // namespace

PixelBox SetupPrimitive::bounds() const {
  PixelBox box;
  for (const SetupFace& face : faces) extend(box, face.polygon.bounds);
  if (umbra) extend(box, umbra->polygon.bounds);
  return box;
}

PrimitiveSetup::PrimitiveSetup(const traces::TraceView& trace, bool z_fail,
                               const datapath::Formats& formats)
    : trace_(trace),
      z_fail_(z_fail),
      formats_(formats),
      steps_(trace.header.depth_format, trace.depth) {}

// No edges: the polygon has no area and covers nothing.
template <typename Polygon>
SetupPolygon PrimitiveSetup::polygon(const Polygon& source) const {
  std::vector<Corner> corners;
  corners.reserve(source.index_count());
  for (std::uint32_t index : trace_.indices.subspan(source.first_index(), source.index_count())) {
    corners.push_back({trace_.vertices[index].x(), trace_.vertices[index].y()});
  }
  std::int64_t area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& p = corners[i];
    const Corner& q = corners[(i + 1) % corners.size()];
    area += p.x * q.y - p.y * q.x;
  }
  SetupPolygon polygon;
  if (area == 0 || corners.size() < 3) return polygon;
  polygon.eye_facing = area < 0;
  if (polygon.eye_facing) std::reverse(corners.begin(), corners.end());
  polygon.edges.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& p = corners[i];
    const Corner& q = corners[(i + 1) % corners.size()];
    if (p.x == q.x && p.y == q.y) continue;
    polygon.edges.push_back(datapath::EdgeFunction::between(p.x, p.y, q.x, q.y));
  }
  polygon.bounds = bounds_of(corners, static_cast<int>(trace_.header.width),
                             static_cast<int>(trace_.header.height));
  return polygon;
}

datapath::FixedPlane PrimitiveSetup::plane(std::uint32_t reference) const {
  return datapath::plane_setup(trace_, reference, steps_, formats_);
}

ZSpan PrimitiveSetup::span(double z_min, double z_max) const {
  return {steps_.first(z_min), steps_.last(z_max)};
}

SetupPrimitive PrimitiveSetup::penumbra(std::uint32_t index) const {
  const traces::fb::Wedge& wedge = trace_.wedges[index];
  SetupPrimitive primitive;
  primitive.wedge = index;
  primitive.coverage = wedge.kind() == traces::fb::WedgeKind_coverage;
  primitive.planes.reserve(wedge.plane_count());
  primitive.faces.reserve(wedge.face_count());
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    primitive.planes.push_back(plane((*wedge.planes())[i]));
  }
  primitive.z = span(wedge.z_min(), wedge.z_max());
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  datapath::FixedBox box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (std::uint32_t i = 0; i < wedge.face_count(); ++i) {
    const traces::fb::Face& face = trace_.faces[wedge.first_face() + i];
    for (std::uint32_t k : trace_.indices.subspan(face.first_index(), face.index_count())) {
      const traces::fb::ScreenVertex& v = trace_.vertices[k];
      box.low = {std::min<std::int64_t>(box.low.x, v.x()), std::min<std::int64_t>(box.low.y, v.y()),
                 std::min(box.low.z, steps_.last(v.z()))};
      box.high = {std::max<std::int64_t>(box.high.x, v.x()),
                  std::max<std::int64_t>(box.high.y, v.y()),
                  std::max(box.high.z, steps_.first(v.z()))};
    }
    SetupPolygon outline = polygon(face);
    if (outline.edges.empty() || outline.eye_facing == z_fail_) continue;
    primitive.faces.push_back(
        {std::move(outline), plane(face.plane()), span(face.z_min(), face.z_max())});
  }
  // With the eye inside it, a wedge is cut by the near plane, where it may have no face.
  if (wedge.z_min() <= 0.0) box.low.z = std::min(box.low.z, steps_.last(wedge.z_min()));
  primitive.vertices = box;
  primitive.light = datapath::light_setup(trace_, wedge, steps_, formats_);
  primitive.inner = plane(wedge.umbra_plane());
  return primitive;
}

std::optional<SetupUmbra> PrimitiveSetup::umbra_of_wedge(std::uint32_t index) const {
  const std::uint32_t polygon = trace_.wedges[index].umbra();
  return polygon == traces::kNone ? std::nullopt : umbra(polygon);
}

std::optional<SetupUmbra> PrimitiveSetup::umbra(std::uint32_t index) const {
  const traces::fb::UmbraPolygon& source = trace_.umbra_polygons[index];
  if (!z_fail_ && source.role() != traces::fb::UmbraRole_side) return {};
  SetupUmbra umbra;
  umbra.polygon = polygon(source);
  if (umbra.polygon.edges.empty()) return {};
  umbra.cap = source.role() == traces::fb::UmbraRole_cap;
  if (!umbra.cap) umbra.inner = plane(source.plane());
  umbra.z = span(source.z_min(), source.z_max());
  // z-pass counts where an eye-facing polygon passes (inner) or another does (not inner); z-fail
  // is the complement of both, and its steps are of the other sign.
  umbra.hits_inner = umbra.polygon.eye_facing != z_fail_;
  umbra.step = umbra.hits_inner ? -1 : 1;
  return umbra;
}

std::vector<std::uint32_t> PrimitiveSetup::lone_umbras() const {
  std::vector<std::uint32_t> lone;
  for (std::uint32_t i = 0; i < trace_.umbra_polygons.size(); ++i) {
    if (trace_.umbra_polygons[i].wedge() == traces::kNone) lone.push_back(i);
  }
  return lone;
}

}  // namespace wedgesim::model::units
