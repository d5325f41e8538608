#include "functional/scene/scene_objects.h"

#include <fmt/format.h>

#include "base/error.h"
#include "functional/scene/manifold.h"
#include "functional/scene/primitives.h"
#include "functional/scene/skin.h"
#include "functional/scene/transform.h"
#include "functional/scene/weld.h"

namespace wedgesim::functional {
namespace {

constexpr int kMaxSegments = 4096;

/// Runs a generator that checks its own parameters; what it says is said at the key's line.
template <typename Make>
Mesh made_at(const TomlTable& table, std::string_view key, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(table.place(key), error.what());
  }
}

Mesh read_box(const TomlTable& table, const ObjectContext&) {
  return make_box(table.vec3("size", {}, Range::size()));
}

Mesh read_plane(const TomlTable& table, const ObjectContext&) {
  const glm::dvec2 size = table.vec2("size", {}, Range::size());
  const int cells = table.integer("cells", 1, 1, kMaxSegments);
  return make_plane(size, {cells, cells});
}

Mesh read_cylinder(const TomlTable& table, const ObjectContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const double height = table.number("height", {}, Range::size());
  return make_lathe({{radius, 0.0}, {radius, height}},
                    table.integer("segments", 48, 3, kMaxSegments));
}

Mesh read_lathe(const TomlTable& table, const ObjectContext&) {
  const std::vector<glm::dvec2> profile = table.vec2_list("profile");
  if (profile.size() < 2) {
    table.fail("profile", "has fewer than 2 points", "points [radius, height] from below");
  }
  const int segments = table.integer("segments", 48, 3, kMaxSegments);
  return made_at(table, "profile", [&] { return make_lathe(profile, segments); });
}

Mesh read_sphere(const TomlTable& table, const ObjectContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const int segments = table.integer("segments", 32, 3, kMaxSegments);
  return make_sphere(radius, segments, table.integer("rings", 16, 2, kMaxSegments));
}

Mesh read_torus(const TomlTable& table, const ObjectContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const double tube = table.number("tube", {}, Range::size());
  if (tube >= radius) {
    table.fail("tube", fmt::format("is {:g}", tube), "less than the radius");
  }
  const int segments = table.integer("segments", 48, 3, kMaxSegments);
  return make_torus(radius, tube, segments, table.integer("tube_segments", 24, 3, kMaxSegments));
}

Mesh read_polygon(const TomlTable& table, const ObjectContext&) {
  const std::vector<glm::dvec2> points = table.vec2_list("points");
  return made_at(table, "points", [&] { return make_thin_polygon(points); });
}

struct Shape {
  std::string_view name;
  Mesh (*read)(const TomlTable&, const ObjectContext&);
};

constexpr Shape kShapes[] = {{"box", read_box},           {"plane", read_plane},
                             {"cylinder", read_cylinder}, {"lathe", read_lathe},
                             {"sphere", read_sphere},     {"torus", read_torus},
                             {"polygon", read_polygon}};

Mesh read_mesh(const TomlTable& table, const ObjectContext& context) {
  const std::string name = table.text("shape");
  std::string known;
  for (const Shape& shape : kShapes) {
    if (shape.name == name) {
      return shape.read(table, context);
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", shape.name);
  }
  table.fail("shape", fmt::format("is '{}'", name), "one of " + known);
}

Placement read_placement(const TomlTable& table) {
  Placement placement;
  placement.scale = table.vec3("scale", placement.scale, Range::size());
  placement.turn_degrees = table.vec3("turn", placement.turn_degrees);
  return placement;
}

std::vector<glm::dvec3> read_positions(const TomlTable& table) {
  if (!table.has("positions")) {
    return {table.vec3("position", glm::dvec3(0.0))};
  }
  if (table.has("position")) {
    table.fail("position", "stands beside 'positions'", "one of the two");
  }
  std::vector<glm::dvec3> positions = table.vec3_list("positions");
  if (positions.empty()) {
    table.fail("positions", "is empty", "points [x, y, z]");
  }
  return positions;
}

}  // namespace

std::vector<Object> read_objects(const TomlTable& table, const ObjectContext& context) {
  Object object;
  object.casts = table.boolean("casts", false);
  object.colour = table.vec3("colour", object.colour, {0.0, 1.0});
  object.mesh = read_mesh(table, context);
  object.mesh.name = table.text("name", table.text("shape"));
  if (object.casts) {
    object.mesh = welded(object.mesh);
    require_closed(object.mesh, table.place());
  }
  Placement placement = read_placement(table);
  const std::vector<glm::dvec3> positions = read_positions(table);
  table.reject_unknown();
  std::vector<Object> objects;
  for (const glm::dvec3& position : positions) {
    placement.position = position;
    Object& at = objects.emplace_back(object);
    at.mesh = placed(object.mesh, placement);
    if (positions.size() > 1) {
      at.mesh.name += fmt::format(" {}", objects.size());
    }
  }
  return objects;
}

}  // namespace wedgesim::functional
