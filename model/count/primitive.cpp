#include "model/count/primitive.h"

#include <algorithm>
#include <limits>

namespace wedgesim::model {
namespace {

using traces::TraceView;

// Window depth: more than rounding moves a vertex, or a pixel that is on a face.
constexpr double kDepthSlack = 1e-9;

template <typename Polygon>
Outline outline_of(const TraceView& trace, const Polygon& polygon) {
  std::vector<Snapped> vertices;
  vertices.reserve(polygon.index_count());
  for (std::uint32_t index : trace.indices.subspan(polygon.first_index(), polygon.index_count())) {
    vertices.push_back({trace.vertices[index].x(), trace.vertices[index].y()});
  }
  return Outline(vertices);
}

void add_faces(const Operands& operands, ZMethod method, const traces::fb::Wedge& wedge,
               Primitive& primitive) {
  const TraceView& trace = operands.trace();
  for (std::uint32_t i = 0; i < wedge.face_count(); ++i) {
    const traces::fb::Face& face = trace.faces[wedge.first_face() + i];
    Outline outline = outline_of(trace, face);
    if (outline.empty() || outline.eye_facing() != (method == ZMethod::pass)) continue;
    primitive.faces.push_back(
        {std::move(outline), operands.plane(face.plane()),
         operands.culling_interval(operands.interval(face.z_min(), face.z_max()), primitive.z)});
    primitive.face_numbers.push_back(wedge.first_face() + i);
  }
}

void add_vertex_bounds(const Operands& operands, const traces::fb::Wedge& wedge,
                       Primitive& primitive) {
  const TraceView& trace = operands.trace();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{kInfinity, -kInfinity, kInfinity, -kInfinity, {kInfinity, -kInfinity}};
  for (std::uint32_t i = 0; i < wedge.face_count(); ++i) {
    const traces::fb::Face& face = trace.faces[wedge.first_face() + i];
    for (std::uint32_t index : trace.indices.subspan(face.first_index(), face.index_count())) {
      const traces::fb::ScreenVertex& vertex = trace.vertices[index];
      box.x0 = std::min(box.x0, vertex.x() / 256.0);
      box.x1 = std::max(box.x1, vertex.x() / 256.0);
      box.y0 = std::min(box.y0, vertex.y() / 256.0);
      box.y1 = std::max(box.y1, vertex.y() / 256.0);
      box.z.min = std::min(box.z.min, vertex.z());
      box.z.max = std::max(box.z.max, vertex.z());
    }
  }
  if (wedge.face_count() > 0) {
    // With the eye inside it, a wedge is cut by the near plane, where it may have no face.
    if (wedge.z_min() <= 0.0) box.z.min = std::min(box.z.min, wedge.z_min());
    box.z = operands.culling_interval(
        operands.around(box.z.min - kDepthSlack, box.z.max + kDepthSlack), primitive.z);
  }
  primitive.vertex_box = box;
}

void add_polygon(const Operands& operands, ZMethod method, std::uint32_t index,
                 Primitive& primitive) {
  const TraceView& trace = operands.trace();
  const traces::fb::UmbraPolygon& polygon = trace.umbra_polygons[index];
  const bool cap = polygon.role() == traces::fb::UmbraRole_cap;
  if (method == ZMethod::pass && polygon.role() != traces::fb::UmbraRole_side) return;
  RasterUmbra umbra;
  umbra.outline = outline_of(trace, polygon);
  if (umbra.outline.empty()) return;
  if (!cap) umbra.inner = operands.plane(polygon.plane());
  umbra.z = operands.interval(polygon.z_min(), polygon.z_max());
  umbra.eye_facing = umbra.outline.eye_facing();
  umbra.cap = cap;
  // z-pass counts where an eye-facing polygon passes (inner) or another does (not inner); z-fail
  // is the complement of both, and its steps are of the other sign.
  umbra.hits_inner = umbra.eye_facing == (method == ZMethod::pass);
  umbra.stencil_step = umbra.hits_inner ? -1 : 1;
  primitive.umbra = index;
  primitive.polygon = std::move(umbra);
}

}  // namespace

std::vector<std::uint32_t> lone_polygons(const TraceView& trace, ZMethod method) {
  std::vector<std::uint32_t> lone;
  for (std::uint32_t i = 0; i < trace.umbra_polygons.size(); ++i) {
    const traces::fb::UmbraPolygon& polygon = trace.umbra_polygons[i];
    if (polygon.wedge() == traces::kNone &&
        (method == ZMethod::fail || polygon.role() == traces::fb::UmbraRole_side)) {
      lone.push_back(i);
    }
  }
  return lone;
}

Primitive wedge_primitive(const Operands& operands, ZMethod method, std::uint32_t index) {
  const TraceView& trace = operands.trace();
  const traces::fb::Wedge& wedge = trace.wedges[index];
  Primitive primitive;
  primitive.wedge = index;
  primitive.coverage = wedge.kind() == traces::fb::WedgeKind_coverage;
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    primitive.planes.push_back(operands.plane((*wedge.planes())[i]));
  }
  primitive.z = operands.interval(wedge.z_min(), wedge.z_max());
  add_faces(operands, method, wedge, primitive);
  add_vertex_bounds(operands, wedge, primitive);
  primitive.terms = operands.terms(wedge);
  primitive.inner = operands.plane(wedge.umbra_plane());
  if (wedge.umbra() != traces::kNone) add_polygon(operands, method, wedge.umbra(), primitive);
  return primitive;
}

Primitive lone_primitive(const Operands& operands, ZMethod method, std::uint32_t polygon) {
  Primitive primitive;
  add_polygon(operands, method, polygon, primitive);
  return primitive;
}

}  // namespace wedgesim::model
