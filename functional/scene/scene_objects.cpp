#include "functional/scene/scene_objects.h"

#include <fmt/format.h>

#include "base/error.h"
#include "functional/scene/manifold.h"
#include "functional/scene/mesh_edges.h"
#include "functional/scene/repair.h"
#include "functional/scene/scene_file.h"
#include "functional/scene/transform.h"
#include "functional/scene/weld.h"

namespace wedgesim::functional {
namespace {

/// Welds a caster and, if it is not closed and may be repaired, repairs it.
Mesh closed(const Mesh& mesh, bool repair, const std::string& place,
            std::vector<std::string>* notes) {
  Mesh caster = welded(mesh);
  bool was_repaired = false;
  if (repair && !is_sound(caster)) {
    std::vector<std::string> done;
    caster = repaired(caster, done);
    was_repaired = true;
    if (notes != nullptr) {
      notes->insert(notes->end(), done.begin(), done.end());
    }
  }
  require_closed(caster, place, was_repaired ? " even after repair" : "");
  caster.edges = mesh_edges(caster);
  return caster;
}

Placement read_placement(const TomlTable& table) {
  Placement placement;
  placement.scale = table.vec3("scale", placement.scale, Range::size());
  placement.turn_degrees = table.vec3("turn", placement.turn_degrees);
  return placement;
}

// As many copies each way as the field says, each smaller by that, over the same square.
std::vector<glm::dvec3> read_field(const TomlTable& table, const ObjectContext& context,
                                   Placement& placement) {
  const TomlTable field = table.table("field");
  const int own_side = field.integer("side", {}, 1, kMostFieldSide);
  const int side = context.field_side.value_or(own_side);
  const double size = field.number("size", {}, Range::size());
  field.reject_unknown();
  placement.scale /= side;
  std::vector<glm::dvec3> positions;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::dvec3 place{(column + 0.5) / side - 0.5, 0.0, (row + 0.5) / side - 0.5};
      positions.push_back(table.vec3("position", glm::dvec3(0.0)) + size * place);
    }
  }
  return positions;
}

std::vector<glm::dvec3> read_positions(const TomlTable& table, const ObjectContext& context,
                                       Placement& placement) {
  if (table.has("field")) return read_field(table, context, placement);
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
  const bool repair = table.boolean("repair", false) || context.repair;
  object.mesh = read_shape(table, context.shape);
  object.mesh.name = table.text("name", object.mesh.name);
  if (object.casts) {
    const bool is_user = context.shape.user_mesh && table.text("shape") == "user";
    const std::string place = is_user ? context.shape.user_mesh->string() : table.place();
    object.mesh = closed(object.mesh, repair, place, context.notes);
  }
  if (table.has("fit")) {
    object.mesh = fitted(std::move(object.mesh), table.number("fit", {}, Range::size()));
  }
  Placement placement = read_placement(table);
  const std::vector<glm::dvec3> positions = read_positions(table, context, placement);
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
