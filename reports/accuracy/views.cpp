#include "reports/accuracy/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <glm/common.hpp>
#include <map>
#include <system_error>

#include "base/error.h"
#include "base/limits.h"
#include "base/toml_table.h"
#include "functional/scene/mesh_edges.h"
#include "functional/scene/primitives.h"

namespace wedgesim::reports::accuracy {
namespace {

using functional::Mesh;
using functional::Scene;

// In the place of another torus of the same radii: as large as that, where that is.
Mesh torus_like(const Mesh& old, const std::array<int, 2>& segments) {
  glm::dvec3 low = old.positions.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& p : old.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Mesh torus = functional::make_torus(1.0, 0.45, segments[0], segments[1]);
  const double scale = (high.x - low.x) / 2.9;
  for (glm::dvec3& p : torus.positions) p = scale * p + 0.5 * (low + high);
  torus.name = old.name;
  torus.edges = functional::mesh_edges(torus);
  return torus;
}

// Each triangle into four by the middles of its edges.
Mesh subdivided(const Mesh& mesh) {
  Mesh fine;
  fine.name = mesh.name;
  fine.positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, added] =
        middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.positions.size()));
    if (added) fine.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  fine.edges = functional::mesh_edges(fine);
  return fine;
}

std::pair<int, int> read_size(const std::string& text, const TomlTable& table) {
  int width = 0;
  int height = 0;
  const char* end = text.data() + text.size();
  const auto [x, first] = std::from_chars(text.data(), end, width);
  const bool cross = first == std::errc() && x != end && *x == 'x';
  const auto [stop, second] = cross ? std::from_chars(x + 1, end, height)
                                    : std::from_chars_result{x, std::errc::invalid_argument};
  if (second != std::errc() || stop != end || width < 1 || height < 1 || width > kMaxFrameEdge ||
      height > kMaxFrameEdge) {
    table.fail("size", fmt::format("is '{}'", text), "WIDTHxHEIGHT in pixels");
  }
  return {width, height};
}

std::vector<std::string> read_sizes(const toml::table& raw, const TomlTable& table) {
  if (!table.has("size")) return {};
  std::vector<std::string> sizes;
  if (const toml::array* several = raw["size"].as_array()) {
    for (const toml::node& one : *several) sizes.push_back(one.value_or(std::string()));
  } else {
    sizes.push_back(table.text("size"));
  }
  return sizes;
}

View read_view(const TomlTable& table) {
  View view;
  view.name = table.text("name");
  view.scene = table.text("scene");
  view.options.frame = table.integer("frame", 0);
  view.options.light_scale = table.number("light_scale", 1.0, Range::size());
  view.subdivide = table.integer("subdivide", 0, 0, 4);
  view.light_away = table.number("light_away", 1.0, Range::size());
  view.published = table.boolean("published", false);
  if (table.has("torus")) {
    const glm::dvec2 segments = table.vec2("torus", {}, {3.0, 4096.0});
    view.torus = {static_cast<int>(segments.x), static_cast<int>(segments.y)};
  }
  if (table.has("mesh")) view.options.mesh = table.text("mesh");
  if (table.has("light")) {
    const std::string shape = table.text("light");
    if (shape != "rect" && shape != "sphere") {
      table.fail("light", fmt::format("is '{}'", shape), "rect or sphere");
    }
    view.options.light_shape =
        shape == "rect" ? functional::LightShape::rectangle : functional::LightShape::sphere;
  }
  return view;
}

}  // namespace

std::optional<Scene> View::load(const std::filesystem::path& meshes) const {
  functional::SceneOptions changed = options;
  if (changed.mesh) {
    changed.mesh = meshes / *changed.mesh;
    std::error_code error;
    if (!std::filesystem::is_regular_file(*changed.mesh, error)) return std::nullopt;
  }
  Scene loaded = functional::load_scene(scene, changed);
  loaded.name = name;
  functional::Light& light = loaded.light;
  light.centre *= light_away;
  light.half_u *= light_away;
  light.half_v *= light_away;
  light.radius *= light_away;
  for (functional::Object& object : loaded.objects) {
    if (!object.casts) continue;
    if (torus) object.mesh = torus_like(object.mesh, *torus);
    for (int i = 0; i < subdivide; ++i) object.mesh = subdivided(object.mesh);
  }
  return loaded;
}

std::vector<View> parse_views(std::string_view text, const std::string& file) {
  const toml::table root = parse_toml(text, file);
  std::vector<View> views;
  const toml::array* all = root["view"].as_array();
  if (all == nullptr) throw InputError(file, "holds no [[view]]", "views");
  for (const toml::node& one : *all) {
    const TomlTable table(*one.as_table(), file);
    View view = read_view(table);
    const std::vector<std::string> sizes = read_sizes(*one.as_table(), table);
    table.reject_unknown();
    if (sizes.empty()) views.push_back(view);
    for (const std::string& size : sizes) {
      views.push_back(view);
      views.back().options.size = read_size(size, table);
      if (sizes.size() > 1) views.back().name = fmt::format("{} {}", view.name, size);
    }
  }
  return views;
}

const std::vector<View>& built_in_views() {
  static const std::vector<View> views =
      parse_views(built_in_view_files().front().text, "reports/accuracy/views.toml");
  return views;
}

}  // namespace wedgesim::reports::accuracy
