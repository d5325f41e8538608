#include <ostream>
#include <span>
#include <string_view>

#include "traces/dump.h"
#include "traces/json_stream.h"

namespace wedgesim::traces {
namespace {

/// One `put` for each type of the schema, in the order of its fields.
class Dump {
 public:
  explicit Dump(std::ostream& out) : json_(out) {}

  void put(const TraceView& trace) {
    const Header& header = trace.header;
    json_.begin('{');
    text("name", header.name);
    field("width", header.width);
    field("height", header.height);
    json_.line();
    field("camera", header.camera);
    table("lights", std::span(header.lights), 1);
    table("casters", std::span(header.casters), 1);
    table("vertices", trace.vertices, 1);
    table("indices", trace.indices, 16);
    table("planes", trace.planes, 1);
    table("faces", trace.faces, 1);
    table("wedges", trace.wedges, 1);
    table("umbra_polygons", trace.umbra_polygons, 1);
    json_.line();
    text("depth_format", fb::EnumNameDepthFormat(header.depth_format));
    table("depth", trace.depth, header.width);
    json_.line();
    field("z_fail_needed", header.z_fail_needed);
    text("expected_z_method", fb::EnumNameZMethod(header.expected_z_method));
    optional_table("expected_li", trace.expected_li, header.width);
    optional_table("li_sensitivity", trace.li_sensitivity, header.width);
    json_.line();
    json_.end('}');
  }

 private:
  void put(double value) { json_.value(value); }
  void put(std::uint32_t value) { json_.value(value); }
  void put(std::int32_t value) { json_.value(value); }
  void put(bool value) { json_.value(value); }

  template <typename T>
  void field(std::string_view name, const T& value) {
    json_.key(name);
    put(value);
  }
  void text(std::string_view name, std::string_view value) {
    json_.key(name);
    json_.value(value);
  }

  /// Elements of a table, `per_line` of them a line.
  template <typename T>
  void table(std::string_view name, std::span<const T> values, std::size_t per_line) {
    json_.line();
    json_.key(name);
    json_.begin('[');
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % per_line == 0) json_.line();
      put(values[i]);
    }
    json_.end(']');
  }
  template <typename T>
  void optional_table(std::string_view name, std::span<const T> values, std::size_t per_line) {
    if (!values.empty()) return table(name, values, per_line);
    json_.line();
    json_.key(name);
    json_.null();
  }

  template <typename T, std::uint16_t size>
  void put(const flatbuffers::Array<T, size>& values) {
    json_.begin('[');
    for (std::uint16_t i = 0; i < size; ++i) put(values[i]);
    json_.end(']');
  }
  void put(const fb::Vec3& value) {
    json_.begin('{');
    field("x", value.x());
    field("y", value.y());
    field("z", value.z());
    json_.end('}');
  }
  void put(const fb::Matrix4& value) {
    json_.begin('{');
    field("columns", *value.columns());
    json_.end('}');
  }
  void put(const fb::ScreenVertex& value) {
    json_.begin('{');
    field("x", value.x());
    field("y", value.y());
    field("z", value.z());
    json_.end('}');
  }
  void put(const fb::Plane& value) {
    json_.begin('{');
    field("a", value.a());
    field("b", value.b());
    field("c", value.c());
    field("d", value.d());
    json_.end('}');
  }
  void put(const fb::Face& value) {
    json_.begin('{');
    field("first_index", value.first_index());
    field("index_count", value.index_count());
    field("plane", value.plane());
    field("z_min", value.z_min());
    field("z_max", value.z_max());
    json_.end('}');
  }
  void put(const fb::UmbraPolygon& value) {
    json_.begin('{');
    field("first_index", value.first_index());
    field("index_count", value.index_count());
    field("plane", value.plane());
    field("wedge", value.wedge());
    field("caster", value.caster());
    text("role", fb::EnumNameUmbraRole(value.role()));
    field("z_min", value.z_min());
    field("z_max", value.z_max());
    json_.end('}');
  }
  void put(const fb::Wedge& value) {
    json_.begin('{');
    field("planes", *value.planes());
    field("plane_count", std::uint32_t{value.plane_count()});
    text("kind", fb::EnumNameWedgeKind(value.kind()));
    field("first_face", value.first_face());
    field("face_count", value.face_count());
    field("umbra", value.umbra());
    field("umbra_plane", value.umbra_plane());
    field("light", value.light());
    field("caster", value.caster());
    field("z_min", value.z_min());
    field("z_max", value.z_max());
    field("edge_begin", value.edge_begin());
    field("edge_end", value.edge_end());
    field("linear_factors", *value.linear_factors());
    json_.end('}');
  }
  void put(const Light& light) {
    json_.begin('{');
    text("shape", fb::EnumNameLightShape(light.shape));
    field("centre", light.centre);
    field("half_u", light.half_u);
    field("half_v", light.half_v);
    field("radius", light.radius);
    field("colour", light.colour);
    field("texture_width", light.texture_width);
    field("texture_height", light.texture_height);
    optional_table("texture", std::span(light.texture), 3 * std::size_t{light.texture_width});
    field("light_from_window", light.light_from_window);
    json_.end('}');
  }
  void put(const Caster& caster) {
    json_.begin('{');
    text("name", caster.name);
    field("triangles", caster.triangles);
    field("z_fail_needed", caster.z_fail_needed);
    json_.end('}');
  }
  void put(const Camera& camera) {
    json_.begin('{');
    field("eye", camera.eye);
    table("near_rectangle", std::span<const fb::Vec3>(camera.near_rectangle), 4);
    field("window_from_world", camera.window_from_world);
    field("world_from_window", camera.world_from_window);
    json_.end('}');
  }

  JsonStream json_;
};

}  // namespace

void dump_json(std::ostream& out, const TraceView& trace) {
  Dump(out).put(trace);
  out << '\n';
}

}  // namespace wedgesim::traces
