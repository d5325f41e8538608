#include "functional/scene/shapes.h"

#include <fmt/format.h>

#include "base/error.h"
#include "functional/scene/landscape.h"
#include "functional/scene/mesh_file.h"
#include "functional/scene/primitives.h"
#include "functional/scene/skin.h"
#include "functional/scene/teapot.h"
#include "functional/scene/text.h"

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

void note_file(const ShapeContext& context, const std::filesystem::path& path) {
  if (context.files != nullptr) context.files->push_back(path);
}

Mesh read_box(const TomlTable& table, const ShapeContext&) {
  return make_box(table.vec3("size", {}, Range::size()));
}

Mesh read_plane(const TomlTable& table, const ShapeContext&) {
  const glm::dvec2 size = table.vec2("size", {}, Range::size());
  const int cells = table.integer("cells", 1, 1, kMaxSegments);
  return make_plane(size, {cells, cells});
}

Mesh read_cylinder(const TomlTable& table, const ShapeContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const double height = table.number("height", {}, Range::size());
  return make_lathe({{radius, 0.0}, {radius, height}},
                    table.integer("segments", 48, 3, kMaxSegments));
}

Mesh read_lathe(const TomlTable& table, const ShapeContext&) {
  const std::vector<glm::dvec2> profile = table.vec2_list("profile");
  if (profile.size() < 2) {
    table.fail("profile", "has fewer than 2 points", "points [radius, height] from below");
  }
  const int segments = table.integer("segments", 48, 3, kMaxSegments);
  return made_at(table, "profile", [&] { return make_lathe(profile, segments); });
}

Mesh read_sphere(const TomlTable& table, const ShapeContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const int segments = table.integer("segments", 32, 3, kMaxSegments);
  return make_sphere(radius, segments, table.integer("rings", 16, 2, kMaxSegments));
}

Mesh read_torus(const TomlTable& table, const ShapeContext&) {
  const double radius = table.number("radius", {}, Range::size());
  const double tube = table.number("tube", {}, Range::size());
  if (tube >= radius) {
    table.fail("tube", fmt::format("is {:g}", tube), "less than the radius");
  }
  const int segments = table.integer("segments", 48, 3, kMaxSegments);
  return make_torus(radius, tube, segments, table.integer("tube_segments", 24, 3, kMaxSegments));
}

Mesh read_polygon(const TomlTable& table, const ShapeContext&) {
  const std::vector<glm::dvec2> points = table.vec2_list("points");
  return made_at(table, "points", [&] { return make_thin_polygon(points); });
}

Mesh read_landscape(const TomlTable& table, const ShapeContext&) {
  LandscapeStyle style;
  style.size = table.vec2("size", style.size, Range::size());
  style.height = table.number("height", style.height, Range::size());
  style.cells = table.integer("cells", style.cells, 1, kMaxSegments);
  style.octaves = table.integer("octaves", style.octaves, 1, 16);
  style.features = table.number("features", style.features, {0.01, 1000.0});
  style.seed = static_cast<std::uint32_t>(table.integer("seed", 1, 0));
  return make_landscape(style);
}

Mesh read_teapot(const TomlTable& table, const ShapeContext&) {
  const double height = table.number("height", 1.0, Range::size());
  return make_teapot(height, table.integer("segments", 48, 3, kMaxSegments));
}

Mesh read_text(const TomlTable& table, const ShapeContext& context) {
  TextStyle style;
  style.height = table.number("height", style.height, Range::size());
  style.depth = table.number("depth", style.depth, Range::size());
  style.curve_segments = table.integer("curve_segments", style.curve_segments, 1, 64);
  if (table.has("font")) {
    style.font = context.folder / table.text("font");
    note_file(context, style.font);
  }
  const std::string text = table.text("text");
  return made_at(table, "text", [&] { return make_text(text, style); });
}

Mesh read_file(const TomlTable& table, const ShapeContext& context) {
  const std::filesystem::path path = context.folder / table.text("file");
  note_file(context, path);
  return made_at(table, "file", [&] { return load_mesh(path); });
}

/// The mesh of --mesh; without it a torus, so that the scene is one as it stands.
Mesh read_user(const TomlTable&, const ShapeContext& context) {
  if (!context.user_mesh) return make_torus(1.0, 0.45, 64, 32);
  note_file(context, *context.user_mesh);
  return load_mesh(*context.user_mesh);
}

struct Shape {
  std::string_view name;
  Mesh (*read)(const TomlTable&, const ShapeContext&);
};

constexpr Shape kShapes[] = {
    {"box", read_box},         {"plane", read_plane},         {"cylinder", read_cylinder},
    {"lathe", read_lathe},     {"sphere", read_sphere},       {"torus", read_torus},
    {"polygon", read_polygon}, {"landscape", read_landscape}, {"teapot", read_teapot},
    {"text", read_text},       {"mesh", read_file},           {"user", read_user}};

}  // namespace

Mesh read_shape(const TomlTable& table, const ShapeContext& context) {
  const std::string name = table.text("shape");
  std::string known;
  for (const Shape& shape : kShapes) {
    if (shape.name == name) {
      Mesh mesh = shape.read(table, context);
      if (mesh.name.empty()) {
        mesh.name = name;
      }
      return mesh;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", shape.name);
  }
  table.fail("shape", fmt::format("is '{}'", name), "one of " + known);
}

}  // namespace wedgesim::functional
