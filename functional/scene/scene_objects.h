#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/toml_table.h"
#include "functional/scene/scene.h"
#include "functional/scene/shapes.h"

namespace wedgesim::functional {

/// What an object may depend on besides its own table.
struct ObjectContext {
  ShapeContext shape;
  bool repair = false;                        // as if every caster said so
  std::vector<std::string>* notes = nullptr;  // gets what repairs did
  std::optional<int> field_side;              // in the place of every field's own
};

/// The objects of one [[object]] table: one for each position. Casters are welded and closed.
/// \throws InputError at FILE:LINE, or naming the mesh
std::vector<Object> read_objects(const TomlTable& table, const ObjectContext& context);

}  // namespace wedgesim::functional
