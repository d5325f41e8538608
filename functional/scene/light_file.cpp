#include "functional/scene/light_file.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "functional/scene/light_texture.h"

namespace wedgesim::functional {
namespace {

glm::dvec3 read_target(const TomlTable& table, glm::dvec3 centre,
                       std::optional<glm::dvec3> fallback = {}) {
  const glm::dvec3 target = table.vec3("target", fallback);
  if (target == centre) {
    table.fail("target", "is the light's centre", "a point elsewhere");
  }
  return target;
}

void read_rectangle(const TomlTable& table, LightFile& file) {
  Light& light = file.light;
  if (table.has("half_u") || table.has("half_v")) {
    light.half_u = table.vec3("half_u");
    light.half_v = table.vec3("half_v");
    const double product = glm::length(light.half_u) * glm::length(light.half_v);
    if (std::abs(glm::dot(light.half_u, light.half_v)) > 1e-9 * product) {
      table.fail("half_v", "is not orthogonal to 'half_u'", "orthogonal half axes");
    }
    file.target = light.centre + glm::cross(light.half_u, light.half_v);
    return;
  }
  const glm::dvec2 size = table.vec2("size", {}, {0.0, Range::kLargest});
  file.target = read_target(table, light.centre);
  const glm::dvec3 colour = light.colour;
  light = aimed_rectangle(light.centre, file.target, 0.5 * size.x, 0.5 * size.y,
                          table.number("roll", 0.0));
  light.colour = colour;
}

std::shared_ptr<const Image> read_texture(const TomlTable& table, const LightContext& context) {
  const auto of_frame = [&](std::size_t count) {
    return static_cast<std::size_t>(context.frame) % count;
  };
  if (table.has("fire")) {
    if (table.has("textures")) table.fail("textures", "stands beside 'fire'", "one of them");
    const TomlTable fire = table.table("fire");
    const int frames = fire.integer("frames", 16, 1, 1000);
    const int side = fire.integer("side", 32, 2, 256);
    const int seed = fire.integer("seed", 1);
    fire.reject_unknown();
    const auto frame = static_cast<int>(of_frame(static_cast<std::size_t>(frames)));
    return std::make_shared<const Image>(
        make_fire(frame, frames, side, static_cast<std::uint32_t>(seed)));
  }
  const auto files = light_textures(table, context.folder);
  if (files.empty()) return nullptr;
  return std::make_shared<const Image>(read_light_texture(files[of_frame(files.size())]));
}

}  // namespace

std::vector<std::filesystem::path> light_textures(const TomlTable& table,
                                                  const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!table.has("textures")) return files;
  for (const std::string& name : table.text_list("textures")) files.push_back(folder / name);
  return files;
}

Light aimed_rectangle(glm::dvec3 centre, glm::dvec3 target, double half_u, double half_v,
                      double roll_degrees) {
  const glm::dvec3 along = glm::normalize(target - centre);
  const bool steep = std::abs(along.y) > 1.0 - 1e-9;
  const glm::dvec3 across = steep ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 level = glm::normalize(glm::cross(along, across));
  const double roll = glm::radians(roll_degrees);
  const glm::dvec3 u = std::cos(roll) * level + std::sin(roll) * glm::cross(along, level);
  Light light;
  light.shape = LightShape::rectangle;
  light.centre = centre;
  light.half_u = half_u * u;
  light.half_v = half_v * glm::cross(along, u);
  return light;
}

LightFile read_light(const TomlTable& table, const LightContext& context) {
  LightFile file;
  Light& light = file.light;
  const std::string shape = table.text("shape", "rectangle");
  light.centre = table.vec3("centre");
  light.colour = table.vec3("colour", light.colour, {0.0, Range::kLargest});
  if (shape == "rectangle") {
    read_rectangle(table, file);
    light.texture = read_texture(table, context);
  } else if (shape == "sphere" || shape == "point") {
    light.shape = shape == "sphere" ? LightShape::sphere : LightShape::point;
    light.radius = shape == "sphere" ? table.number("radius", {}, {0.0, Range::kLargest}) : 0.0;
    file.target = read_target(table, light.centre, light.centre - glm::dvec3(0.0, 1.0, 0.0));
  } else {
    table.fail("shape", fmt::format("is '{}'", shape), "rectangle, sphere or point");
  }
  table.reject_unknown();
  return file;
}

Light reshaped(const LightFile& file, LightShape shape) {
  const Light& from = file.light;
  if (from.shape == shape) {
    return from;
  }
  double half = 0.0;
  if (has_extent(from)) {
    half = from.shape == LightShape::sphere
               ? from.radius
               : 0.5 * (glm::length(from.half_u) + glm::length(from.half_v));
  }
  Light light;
  if (shape == LightShape::rectangle) {
    light = aimed_rectangle(from.centre, file.target, half, half);
  } else if (shape == LightShape::sphere) {
    light.radius = half;
  }
  light.shape = shape;
  light.centre = from.centre;
  light.colour = from.colour;
  return light;
}

}  // namespace wedgesim::functional
