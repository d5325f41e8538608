#include "tests/model/count/synthetic.h"

#include <algorithm>
#include <cmath>

#include "traces/depth.h"

namespace wedgesim::model::test {
namespace {

using traces::kNone;
namespace fb = traces::fb;

std::int32_t snap(double pixels) { return static_cast<std::int32_t>(std::lround(pixels * 256.0)); }

// Negative: seen counter-clockwise, y up.
std::int64_t doubled_area(const std::vector<Point>& outline) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& p = outline[i];
    const Point& q = outline[(i + 1) % outline.size()];
    area += std::int64_t{snap(p.x)} * snap(q.y) - std::int64_t{snap(p.y)} * snap(q.x);
  }
  return area;
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
unsigned below(std::mt19937& random, unsigned limit) {
  return std::uniform_int_distribution<unsigned>(0, limit - 1)(random);
}

// A homogeneous light space that gives the formulas something to do: u and v about the frame's
// middle, height growing towards the eye, w near 1.
fb::Matrix4 light_matrix(double width, double height) {
  std::array<double, 16> m{};
  const auto set = [&](std::size_t row, double a, double b, double c, double d) {
    m[row] = a;
    m[4 + row] = b;
    m[8 + row] = c;
    m[12 + row] = d;
  };
  set(0, 4.0 / width, 0.3 / height, 0.5, -2.2);
  set(1, -0.2 / width, 4.0 / height, 0.7, -2.1);
  set(2, 0.1 / width, 0.2 / height, 1.0, 2.5);
  set(3, 0.02 / width, 0.01 / height, 0.03, 1.0);
  return fb::Matrix4(flatbuffers::span<const double, 16>(m));
}

fb::Vec3 random_vec(std::mt19937& random, double size, double z_low, double z_high) {
  const double x = uniform(random, -size, size);
  const double y = uniform(random, -size, size);
  return {x, y, uniform(random, z_low, z_high)};
}

void randomize_wedge_light(std::mt19937& random, fb::Wedge& wedge) {
  wedge.mutable_edge_begin() = random_vec(random, 1.5, 0.8, 2.0);
  wedge.mutable_edge_end() = random_vec(random, 1.5, 0.8, 2.0);
  for (std::uint16_t i = 0; i < 6; ++i) {
    wedge.mutable_linear_factors()->Mutate(i, uniform(random, 0.2, 2.0));
  }
}

Point random_point(std::mt19937& random, const traces::Header& header) {
  const double margin = 0.2;
  const auto grid = [](double v) { return std::round(v * 256.0) / 256.0; };
  return {grid(uniform(random, -margin, 1 + margin) * header.width),
          grid(uniform(random, -margin, 1 + margin) * header.height), uniform(random, 0.05, 0.95)};
}

Point mix(const Point& p, const Point& q, double t) {
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
}

Point snapped(const Point& p) { return {snap(p.x) / 256.0, snap(p.y) / 256.0, p.z}; }

Facing facing_of(const std::vector<Point>& outline) {
  return doubled_area(outline) < 0 ? Facing::eye : Facing::away;
}

// Which side of a plane through a triangle of a closed body faces the eye: its inside is far.
Facing facing_of(const traces::Trace& trace, std::uint32_t plane) {
  const double c = trace.planes[traces::plane_index(plane)].c();
  return (traces::is_minus(plane) ? -c : c) > 0.0 ? Facing::eye : Facing::away;
}

void randomize_depth(std::mt19937& random, SyntheticTrace& synthetic) {
  const traces::Header& header = synthetic.trace.header;
  const double base = uniform(random, 0.25, 0.6);
  const double slope = uniform(random, -0.3, 0.3) / header.width;
  const unsigned step_x = below(random, header.width + 1);
  for (std::uint32_t y = 0; y < header.height; ++y) {
    for (std::uint32_t x = 0; x < header.width; ++x) {
      double z = base + slope * x + (x < step_x ? 0.15 : 0.0) + uniform(random, 0.0, 0.01);
      if (below(random, 12) == 0) z = 1.0;
      synthetic.set_depth(x, y, z);
    }
  }
}

fb::LightShape random_shape(std::mt19937& random) {
  return below(random, 2) == 0 ? fb::LightShape_rectangle : fb::LightShape_sphere;
}

fb::DepthFormat random_format(std::mt19937& random) {
  return static_cast<fb::DepthFormat>(below(random, 4));
}

// The four faces of a tetrahedron as planes and triangles, inside towards its middle.
struct Tetrahedron {
  std::array<Point, 4> corners;
  Point middle() const {
    return mix(mix(corners[0], corners[1], 0.5), mix(corners[2], corners[3], 0.5), 0.5);
  }
  std::array<Point, 3> face(std::size_t i) const {
    return {corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]};
  }
};

Tetrahedron random_tetrahedron(std::mt19937& random, const traces::Header& header,
                               double thickness) {
  Tetrahedron body;
  for (Point& corner : body.corners) corner = random_point(random, header);
  if (thickness < 1.0) {
    body.corners[2] = snapped(mix(body.corners[0], body.corners[2], thickness));
    body.corners[3] = snapped(mix(body.corners[1], body.corners[3], thickness));
  }
  return body;
}

void add_tetrahedron_wedge(std::mt19937& random, SyntheticTrace& synthetic, double thickness) {
  const Tetrahedron body = random_tetrahedron(random, synthetic.trace.header, thickness);
  std::vector<std::uint32_t> planes;
  double z_min = 1.0;
  double z_max = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto face = body.face(i);
    planes.push_back(synthetic.add_plane(face, body.middle(), below(random, 2) == 0));
    synthetic.add_face({face.begin(), face.end()}, facing_of(synthetic.trace, planes.back()),
                       planes.back());
    z_min = std::min(z_min, body.corners[i].z);
    z_max = std::max(z_max, body.corners[i].z);
  }
  const auto kind = below(random, 3) == 0 ? fb::WedgeKind_linear : fb::WedgeKind_coverage;
  const std::uint32_t wedge = synthetic.add_wedge(kind, planes, z_min, z_max);
  randomize_wedge_light(random, synthetic.trace.wedges[wedge]);
  // Its umbra polygon: a triangle through the body, or poking out of it.
  const double reach = below(random, 3) == 0 ? 1.2 : 0.5;
  std::array<Point, 3> triangle{mix(body.corners[0], body.corners[1], reach),
                                mix(body.corners[0], body.corners[2], reach), body.corners[3]};
  for (Point& p : triangle) p = snapped(p);
  const Point within = body.corners[below(random, 2)];
  const std::uint32_t plane = synthetic.add_plane(triangle, within, below(random, 2) == 0);
  synthetic.add_umbra({triangle.begin(), triangle.end()}, facing_of(synthetic.trace, plane), plane,
                      wedge);
}

void add_umbra_body(std::mt19937& random, SyntheticTrace& synthetic) {
  const Tetrahedron body = random_tetrahedron(random, synthetic.trace.header, 1.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto face = body.face(i);
    const std::uint32_t plane = synthetic.add_plane(face, body.middle());
    synthetic.add_umbra({face.begin(), face.end()}, facing_of(synthetic.trace, plane), plane,
                        kNone);
  }
}

std::vector<Point> random_triangle(std::mt19937& random, const traces::Header& header) {
  std::vector<Point> outline(3);
  for (Point& point : outline) point = random_point(random, header);
  return outline;
}

std::uint32_t random_plane(std::mt19937& random, SyntheticTrace& synthetic) {
  const traces::Header& header = synthetic.trace.header;
  const Point at = random_point(random, header);
  const double a = uniform(random, -1, 1) / header.width;
  const double b = uniform(random, -1, 1) / header.height;
  const double c = uniform(random, -1, 1);
  return synthetic.add_plane(a, b, c, -(a * at.x + b * at.y + c * at.z), below(random, 2) == 0);
}

void add_nonsense_wedge(std::mt19937& random, SyntheticTrace& synthetic) {
  const traces::Header& header = synthetic.trace.header;
  const unsigned faces = 1 + below(random, 4);
  for (unsigned i = 0; i < faces; ++i) {
    const auto outline = random_triangle(random, header);
    synthetic.add_face(outline, facing_of(outline), random_plane(random, synthetic));
  }
  std::vector<std::uint32_t> planes;
  const bool linear = below(random, 3) == 0;
  for (unsigned i = 0; i < (linear ? 4 : 1 + below(random, 3)); ++i) {
    planes.push_back(random_plane(random, synthetic));
  }
  const std::uint32_t wedge =
      synthetic.add_wedge(linear ? fb::WedgeKind_linear : fb::WedgeKind_coverage, planes,
                          uniform(random, 0.0, 0.5), uniform(random, 0.5, 1.0));
  randomize_wedge_light(random, synthetic.trace.wedges[wedge]);
  if (linear && below(random, 3) == 0) return;  // without an umbra polygon
  const auto outline = random_triangle(random, header);
  synthetic.add_umbra(outline, facing_of(outline), random_plane(random, synthetic), wedge);
}

}  // namespace

SyntheticTrace::SyntheticTrace(std::uint32_t width, std::uint32_t height, double depth,
                               fb::LightShape shape, fb::DepthFormat format) {
  trace.header.name = "synthetic";
  trace.header.width = width;
  trace.header.height = height;
  trace.header.depth_format = format;
  trace.header.casters.push_back({"caster", 1, false});
  traces::Light light;
  light.shape = shape;
  light.radius = 1.0;
  light.light_from_window = light_matrix(width, height);
  trace.header.lights.push_back(light);
  trace.depth.assign(std::size_t{width} * height, traces::encode_depth(format, depth));
}

void SyntheticTrace::set_depth(std::uint32_t x, std::uint32_t y, double depth) {
  trace.depth[std::size_t{y} * trace.header.width + x] =
      traces::encode_depth(trace.header.depth_format, depth);
}

std::uint32_t SyntheticTrace::add_vertex(const Point& point) {
  trace.vertices.emplace_back(snap(point.x), snap(point.y), point.z);
  return static_cast<std::uint32_t>(trace.vertices.size() - 1);
}

std::uint32_t SyntheticTrace::add_plane(double a, double b, double c, double d, bool as_minus) {
  const double sign = as_minus ? -1.0 : 1.0;
  trace.planes.emplace_back(sign * a, sign * b, sign * c, sign * d);
  return traces::plane_reference(static_cast<std::uint32_t>(trace.planes.size() - 1), as_minus);
}

std::uint32_t SyntheticTrace::add_plane(const std::array<Point, 3>& through, const Point& within,
                                        bool as_minus) {
  const auto [p, q, r] = through;
  const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  double a = uy * vz - uz * vy;
  double b = uz * vx - ux * vz;
  double c = ux * vy - uy * vx;
  double d = -(a * p.x + b * p.y + c * p.z);
  if (a * within.x + b * within.y + c * within.z + d < 0.0) {
    a = -a;
    b = -b;
    c = -c;
    d = -d;
  }
  return add_plane(a, b, c, d, as_minus);
}

std::uint32_t SyntheticTrace::add_indices(std::vector<Point> outline, Facing facing) {
  if ((doubled_area(outline) < 0) != (facing == Facing::eye)) {
    std::reverse(outline.begin(), outline.end());
  }
  const auto first = static_cast<std::uint32_t>(trace.indices.size());
  for (const Point& point : outline) trace.indices.push_back(add_vertex(point));
  return first;
}

void SyntheticTrace::add_face(std::vector<Point> outline, Facing facing, std::uint32_t plane) {
  const auto [low, high] = std::minmax_element(
      outline.begin(), outline.end(), [](const Point& a, const Point& b) { return a.z < b.z; });
  const double z_min = low->z;
  const double z_max = high->z;
  const auto count = static_cast<std::uint32_t>(outline.size());
  const std::uint32_t first = add_indices(std::move(outline), facing);
  trace.faces.emplace_back(first, count, plane, z_min, z_max);
}

std::uint32_t SyntheticTrace::add_wedge(fb::WedgeKind kind,
                                        const std::vector<std::uint32_t>& planes, double z_min,
                                        double z_max) {
  std::array<std::uint32_t, 8> references{};
  std::copy(planes.begin(), planes.end(), references.begin());
  const std::array<double, 6> factors{1, 1, 1, 1, 1, 1};
  const auto face_count = static_cast<std::uint32_t>(trace.faces.size()) - first_face_;
  trace.wedges.emplace_back(flatbuffers::span<const std::uint32_t, 8>(references),
                            static_cast<std::uint8_t>(planes.size()), kind, first_face_, face_count,
                            kNone, planes.front(), 0, 0, z_min, z_max, fb::Vec3(-0.5, 0.1, 1.0),
                            fb::Vec3(0.6, 0.2, 1.0), flatbuffers::span<const double, 6>(factors));
  first_face_ += face_count;
  return static_cast<std::uint32_t>(trace.wedges.size() - 1);
}

std::uint32_t SyntheticTrace::add_umbra(std::vector<Point> outline, Facing facing,
                                        std::uint32_t plane, std::uint32_t wedge,
                                        fb::UmbraRole role) {
  const auto [low, high] = std::minmax_element(
      outline.begin(), outline.end(), [](const Point& a, const Point& b) { return a.z < b.z; });
  const double z_min = low->z;
  const double z_max = high->z;
  const auto count = static_cast<std::uint32_t>(outline.size());
  const std::uint32_t first = add_indices(std::move(outline), facing);
  trace.umbra_polygons.emplace_back(first, count, plane, wedge, 0, role, z_min, z_max);
  const auto index = static_cast<std::uint32_t>(trace.umbra_polygons.size() - 1);
  if (wedge != kNone) {
    trace.wedges[wedge].mutate_umbra(index);
    trace.wedges[wedge].mutate_umbra_plane(plane);
  }
  return index;
}

traces::Trace random_nonsense(std::mt19937& random, std::uint32_t width, std::uint32_t height,
                              unsigned wedges) {
  SyntheticTrace synthetic(width, height, 1.0, random_shape(random), random_format(random));
  randomize_depth(random, synthetic);
  for (unsigned i = 0; i < wedges; ++i) add_nonsense_wedge(random, synthetic);
  for (const auto role : {fb::UmbraRole_side, fb::UmbraRole_bottom, fb::UmbraRole_cap}) {
    const auto outline = random_triangle(random, synthetic.trace.header);
    synthetic.add_umbra(outline, facing_of(outline), random_plane(random, synthetic), kNone, role);
  }
  return std::move(synthetic.trace);
}

traces::Trace random_tetrahedra(std::mt19937& random, std::uint32_t width, std::uint32_t height,
                                unsigned wedges, double thickness) {
  SyntheticTrace synthetic(width, height, 1.0, random_shape(random), random_format(random));
  randomize_depth(random, synthetic);
  for (unsigned i = 0; i < wedges; ++i) add_tetrahedron_wedge(random, synthetic, thickness);
  add_umbra_body(random, synthetic);
  return std::move(synthetic.trace);
}

}  // namespace wedgesim::model::test
