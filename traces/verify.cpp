#include "traces/verify.h"

#include <algorithm>
#include <array>

#include "traces/expect.h"

namespace wedgesim::traces {
namespace {

// Floats from 0 to 1 are in the order of their words; NaN, infinities and negative ones are above.
std::uint32_t largest_depth_word(fb::DepthFormat format) {
  switch (format) {
    case fb::DepthFormat_unorm24:
      return 0xffffffU;
    case fb::DepthFormat_unorm16:
      return 0xffffU;
    case fb::DepthFormat_float32:
    case fb::DepthFormat_float32_reversed:
      break;
  }
  return 0x3f800000U;  // 1.0F
}

void verify_length(const Expect& expect, std::string_view section, std::size_t size,
                   std::size_t pixels, bool may_be_absent) {
  if (size == pixels || (may_be_absent && size == 0)) return;
  expect.refuse({section}, "length", size,
                fmt::format("{}, width x height{}", pixels, may_be_absent ? ", or absent" : ""));
}

void verify_frame(const TraceView& trace, const Expect& expect) {
  const Header& header = trace.header;
  expect.between({}, "width", header.width, 1, kMaxSide);
  expect.between({}, "height", header.height, 1, kMaxSide);
  expect.between({}, "depth_format", header.depth_format, 0, fb::DepthFormat_MAX);
  expect.between({}, "expected_z_method", header.expected_z_method, 0, fb::ZMethod_MAX);
  const std::size_t pixels = std::size_t{header.width} * header.height;
  verify_length(expect, "depth", trace.depth.size(), pixels, false);
  verify_length(expect, "expected_li", trace.expected_li.size(), pixels, true);
  verify_length(expect, "li_sensitivity", trace.li_sensitivity.size(), pixels, true);
  const std::uint32_t largest = largest_depth_word(header.depth_format);
  for (std::size_t i = 0; i < trace.depth.size(); ++i) {
    expect.between({"depth", i}, "", trace.depth[i], 0, largest);
  }
  for (std::size_t i = 0; i < trace.expected_li.size(); ++i) {
    expect.finite({"expected_li", i}, "", trace.expected_li[i]);
  }
  for (std::size_t i = 0; i < trace.li_sensitivity.size(); ++i) {
    const float value = trace.li_sensitivity[i];
    expect.finite({"li_sensitivity", i}, "", value);
    if (value < 0) expect.refuse({"li_sensitivity", i}, "", value, "0 or more");
  }
}

void verify_camera(const Camera& camera, const Expect& expect) {
  expect.finite({"camera"}, "eye", camera.eye);
  for (std::size_t i = 0; i < camera.near_rectangle.size(); ++i) {
    expect.finite({"camera.near_rectangle", i}, "", camera.near_rectangle[i]);
  }
  expect.finite({"camera"}, "window_from_world", camera.window_from_world);
  expect.finite({"camera"}, "world_from_window", camera.world_from_window);
}

void verify_light(const Light& light, Spot at, const Expect& expect) {
  expect.between(at, "shape", light.shape, 0, fb::LightShape_MAX);
  expect.finite(at, "centre", light.centre);
  expect.finite(at, "half_u", light.half_u);
  expect.finite(at, "half_v", light.half_v);
  expect.finite(at, "radius", light.radius);
  if (light.radius < 0) expect.refuse(at, "radius", light.radius, "0 or more");
  expect.finite(at, "colour", light.colour);
  expect.finite(at, "light_from_window", light.light_from_window);
  expect.between(at, "texture_width", light.texture_width, 0, kMaxSide);
  expect.between(at, "texture_height", light.texture_height, 0, kMaxSide);
  const std::size_t texels = std::size_t{light.texture_width} * light.texture_height;
  if (light.texture.size() != 3 * texels) {
    expect.refuse(at, "texture.length", light.texture.size(),
                  fmt::format("{}, texture_width x texture_height x 3", 3 * texels));
  }
  const auto bad = std::find_if_not(light.texture.begin(), light.texture.end(),
                                    [](float value) { return std::isfinite(value); });
  if (bad != light.texture.end()) {
    expect.refuse(at, fmt::format("texture[{}]", bad - light.texture.begin()), *bad,
                  "a finite number");
  }
}

void verify_header(const Header& header, const Expect& expect) {
  expect.between({"lights"}, "length", static_cast<std::int64_t>(header.lights.size()), 0,
                 kMaxLights);
  expect.between({"casters"}, "length", static_cast<std::int64_t>(header.casters.size()), 0,
                 kMaxCasters);
  verify_camera(header.camera, expect);
  for (std::size_t i = 0; i < header.lights.size(); ++i) {
    verify_light(header.lights[i], {"lights", i}, expect);
  }
  const bool needed = std::any_of(header.casters.begin(), header.casters.end(),
                                  [](const Caster& caster) { return caster.z_fail_needed; });
  if (header.z_fail_needed != needed) {
    expect.refuse({}, "z_fail_needed", header.z_fail_needed,
                  needed ? "true, as a caster's is" : "false, as no caster's is true");
  }
}

// The tables that others refer to.
void verify_geometry(const TraceView& trace, const Expect& expect) {
  for (std::size_t i = 0; i < trace.vertices.size(); ++i) {
    const fb::ScreenVertex& vertex = trace.vertices[i];
    expect.between({"vertices", i}, "x", vertex.x(), -kMaxSnapped, kMaxSnapped);
    expect.between({"vertices", i}, "y", vertex.y(), -kMaxSnapped, kMaxSnapped);
    expect.finite({"vertices", i}, "z", vertex.z());
  }
  for (std::size_t i = 0; i < trace.indices.size(); ++i) {
    expect.below({"indices", i}, "", trace.indices[i], trace.vertices.size(),
                 "the number of vertices");
  }
  for (std::size_t i = 0; i < trace.planes.size(); ++i) {
    const fb::Plane& plane = trace.planes[i];
    expect.finite({"planes", i}, "a", plane.a());
    expect.finite({"planes", i}, "b", plane.b());
    expect.finite({"planes", i}, "c", plane.c());
    expect.finite({"planes", i}, "d", plane.d());
  }
}

void verify_range(const Expect& expect, Spot at, std::string_view fields, std::uint32_t first,
                  std::uint32_t count, std::size_t size, std::string_view size_name) {
  const std::uint64_t end = std::uint64_t{first} + count;
  if (end > size) expect.refuse(at, fields, end, fmt::format("at most {}, {}", size, size_name));
}

void verify_reference(const TraceView& trace, const Expect& expect, Spot at, std::string_view field,
                      std::uint32_t reference) {
  expect.below(at, field, reference, 2 * trace.planes.size(), "twice the number of planes");
}

/// \param polygon  a face or an umbra polygon
template <typename Polygon>
void verify_polygon(const TraceView& trace, const Expect& expect, Spot at, const Polygon& polygon) {
  expect.between(at, "index_count", polygon.index_count(), 3, kMaxPolygonVertices);
  verify_range(expect, at, "first_index + index_count", polygon.first_index(),
               polygon.index_count(), trace.indices.size(), "the number of indices");
  expect.interval(at, polygon.z_min(), polygon.z_max());
}

constexpr std::array<std::string_view, kMaxWedgePlanes> kPlaneFields = {
    "planes[0]", "planes[1]", "planes[2]", "planes[3]",
    "planes[4]", "planes[5]", "planes[6]", "planes[7]"};

void verify_wedge(const TraceView& trace, const Expect& expect, std::uint32_t index) {
  const Spot at{"wedges", index};
  const fb::Wedge& wedge = trace.wedges[index];
  expect.between(at, "kind", wedge.kind(), 0, fb::WedgeKind_MAX);
  // A linear wedge names its planes by position: front, back, left, right.
  const int fewest = wedge.kind() == fb::WedgeKind_linear ? 4 : 1;
  expect.between(at, "plane_count", wedge.plane_count(), fewest, kMaxWedgePlanes);
  for (std::uint8_t i = 0; i < wedge.plane_count(); ++i) {
    verify_reference(trace, expect, at, kPlaneFields[i], (*wedge.planes())[i]);
  }
  expect.between(at, "face_count", wedge.face_count(), 0, kMaxWedgeFaces);
  verify_range(expect, at, "first_face + face_count", wedge.first_face(), wedge.face_count(),
               trace.faces.size(), "the number of faces");
  expect.below(at, "light", wedge.light(), trace.header.lights.size(), "the number of lights");
  if (trace.header.lights[wedge.light()].shape == fb::LightShape_point) {
    expect.refuse(at, "light", wedge.light(), "a light with an extent: a point has no penumbra");
  }
  expect.below(at, "caster", wedge.caster(), trace.header.casters.size(), "the number of casters");
  expect.interval(at, wedge.z_min(), wedge.z_max());
  expect.finite(at, "edge_begin", wedge.edge_begin());
  expect.finite(at, "edge_end", wedge.edge_end());
  expect.finite(at, "linear_factors", *wedge.linear_factors());
  verify_reference(trace, expect, at, "umbra_plane", wedge.umbra_plane());
  if (wedge.umbra() == kNone) return;
  expect.below(at, "umbra", wedge.umbra(), trace.umbra_polygons.size(),
               "the number of umbra_polygons, or 4294967295 for none");
  const fb::UmbraPolygon& umbra = trace.umbra_polygons[wedge.umbra()];
  if (umbra.wedge() != index) {
    expect.refuse(at, "umbra", wedge.umbra(),
                  fmt::format("an umbra polygon that names this wedge, not {}", umbra.wedge()));
  }
  if (umbra.plane() != wedge.umbra_plane()) {
    expect.refuse(at, "umbra_plane", wedge.umbra_plane(),
                  fmt::format("{}, its umbra polygon's plane", umbra.plane()));
  }
  if (umbra.caster() != wedge.caster()) {
    expect.refuse(at, "caster", wedge.caster(),
                  fmt::format("{}, its umbra polygon's", umbra.caster()));
  }
}

void verify_umbra_polygon(const TraceView& trace, const Expect& expect, std::uint32_t index) {
  const Spot at{"umbra_polygons", index};
  const fb::UmbraPolygon& umbra = trace.umbra_polygons[index];
  verify_polygon(trace, expect, at, umbra);
  expect.between(at, "role", umbra.role(), 0, fb::UmbraRole_MAX);
  if (umbra.role() != fb::UmbraRole_cap) {
    verify_reference(trace, expect, at, "plane", umbra.plane());
  }
  expect.below(at, "caster", umbra.caster(), trace.header.casters.size(), "the number of casters");
  if (umbra.wedge() == kNone) return;
  expect.below(at, "wedge", umbra.wedge(), trace.wedges.size(),
               "the number of wedges, or 4294967295 for none");
  if (trace.wedges[umbra.wedge()].umbra() != index) {
    expect.refuse(at, "wedge", umbra.wedge(), "a wedge that names this umbra polygon");
  }
  if (umbra.role() != fb::UmbraRole_side) {
    expect.refuse(at, "wedge", umbra.wedge(), "4294967295, none: only a side shares a visit");
  }
}

}  // namespace

void verify(const TraceView& trace, std::string_view place) {
  const Expect expect(place);
  verify_frame(trace, expect);
  verify_header(trace.header, expect);
  verify_geometry(trace, expect);
  for (std::size_t i = 0; i < trace.faces.size(); ++i) {
    verify_polygon(trace, expect, {"faces", i}, trace.faces[i]);
    verify_reference(trace, expect, {"faces", i}, "plane", trace.faces[i].plane());
  }
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) verify_wedge(trace, expect, i);
  for (std::uint32_t i = 0; i < trace.umbra_polygons.size(); ++i) {
    verify_umbra_polygon(trace, expect, i);
  }
}

}  // namespace wedgesim::traces
