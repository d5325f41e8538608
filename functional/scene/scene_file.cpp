#include "functional/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "base/limits.h"
#include "base/toml_table.h"
#include "functional/scene/built_in.h"
#include "functional/scene/camera_path.h"
#include "functional/scene/clip_matrix.h"
#include "functional/scene/light_file.h"
#include "functional/scene/scene_check.h"
#include "functional/scene/scene_objects.h"

namespace wedgesim::functional {
namespace {

struct Source {
  std::string name;            // of the scene
  std::string place;           // the file as users know it
  std::filesystem::path file;  // empty: inside the program
  std::string text;
};

struct CameraFile {
  Camera camera;
  std::vector<CameraKey> keys;
  Interpolation interpolation = Interpolation::catmull_rom;
};

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path.string(), "is a folder", "a scene file");
  }
  return std::string(MappedFile(path).text());
}

Source find_source(const std::string& name_or_file) {
  for (const BuiltInFile& file : built_in_files()) {
    if (file.name == name_or_file) {
      const std::string name(file.name);
      return {name, name + ".toml", {}, std::string(file.text)};
    }
  }
  const std::filesystem::path path(name_or_file);
  if (path.extension() != ".toml" && !path.has_parent_path()) {
    std::string known;
    for (const BuiltInFile& file : built_in_files()) {
      known += fmt::format("{}, ", file.name);
    }
    throw InputError(name_or_file, "no such scene", known + "or a .toml file");
  }
  return {path.stem().string(), path.string(), path, read_text(path)};
}

/// \param width_by_height  of the frame
CameraFile read_camera(const TomlTable& table, double width_by_height) {
  CameraFile file;
  Camera& camera = file.camera;
  camera.up = table.vec3("up", camera.up);
  camera.field_of_view_degrees =
      table.number("field_of_view", camera.field_of_view_degrees, {1.0, 170.0});
  camera.near_plane = table.number("near", camera.near_plane, Range::size());
  camera.far_plane = table.number("far", camera.far_plane, Range::size());
  if (camera.far_plane <= camera.near_plane) {
    table.fail("far", "is not beyond 'near'", "near < far");
  }
  const std::string way = table.text("interpolation", "catmull-rom");
  if (way != "linear" && way != "catmull-rom") {
    table.fail("interpolation", fmt::format("is '{}'", way), "linear or catmull-rom");
  }
  file.interpolation = way == "linear" ? Interpolation::linear : Interpolation::catmull_rom;
  if (table.has("clip_from_world")) {
    for (const char* other : {"eye", "target", "key", "up", "field_of_view"}) {
      if (table.has(other)) table.fail(other, "stands beside 'clip_from_world'", "one of them");
    }
    const std::string wrong =
        camera_of_clip_matrix(table.matrix4("clip_from_world"), width_by_height, camera);
    if (!wrong.empty()) {
      table.fail("clip_from_world", wrong, "a symmetric perspective of square pixels");
    }
    table.reject_unknown();
    return file;
  }
  for (const TomlTable& key : table.tables("key")) {
    file.keys.push_back({key.vec3("eye"), key.vec3("target"), key.integer("frames", 0, 0, 100000)});
    key.reject_unknown();
  }
  if (file.keys.empty()) {
    camera.eye = table.vec3("eye");
    camera.target = table.vec3("target");
  }
  table.reject_unknown();
  return file;
}

void check_camera(const Camera& camera, const std::string& place) {
  const glm::dvec3 view = camera.target - camera.eye;
  if (!(glm::length(glm::cross(view, camera.up)) > 1e-9 * glm::length(camera.up))) {
    throw InputError(place, "the camera has no direction, or looks along 'up'",
                     "eye, target and up that span a plane");
  }
}

void set_frame(Scene& scene, const CameraFile& file, int frame, const std::string& place) {
  scene.frames = frame_count(file.keys);
  if (frame < 0 || frame >= scene.frames) {
    throw InputError("--frame", fmt::format("{} has no frame {}", scene.name, frame),
                     fmt::format("0 to {}", scene.frames - 1));
  }
  scene.frame = frame;
  scene.camera = camera_at(file.camera, file.keys, file.interpolation, frame);
  check_camera(scene.camera, place);
}

std::pair<int, int> read_size(const TomlTable& table, int width, int height) {
  const glm::dvec2 size =
      table.vec2("size", glm::dvec2(width, height), {1.0, static_cast<double>(kMaxFrameEdge)});
  if (size.x != std::floor(size.x) || size.y != std::floor(size.y)) {
    table.fail("size", "is not whole", "pixels [width, height]");
  }
  return {static_cast<int>(size.x), static_cast<int>(size.y)};
}

void set_size(Scene& scene, const TomlTable& table, const SceneOptions& options) {
  std::tie(scene.width, scene.height) = read_size(table, scene.width, scene.height);
  if (options.size) {
    const auto [width, height] = *options.size;
    if (width < 1 || height < 1 || width > kMaxFrameEdge || height > kMaxFrameEdge) {
      throw InputError("--size", fmt::format("{}x{}", width, height),
                       fmt::format("1 to {} pixels each way", kMaxFrameEdge));
    }
    scene.width = width;
    scene.height = height;
  }
}

void set_lights(Scene& scene, const TomlTable& table, const std::filesystem::path& folder,
                const SceneOptions& options) {
  std::vector<Light> lights;
  for (const TomlTable& entry : table.one_or_more_tables("light")) {
    const LightFile file = read_light(entry, {folder, options.frame});
    std::ranges::move(light_textures(entry, folder), std::back_inserter(scene.files));
    if (file.light.texture &&
        options.light_shape.value_or(LightShape::rectangle) != LightShape::rectangle) {
      throw InputError("--light", "does not go with the light's texture", "rect");
    }
    Light light = options.light_shape ? reshaped(file, *options.light_shape) : file.light;
    light.half_u *= options.light_scale;
    light.half_v *= options.light_scale;
    light.radius *= options.light_scale;
    if (!has_extent(light)) light = reshaped({light, {}}, LightShape::point);
    lights.push_back(light);
  }
  scene.light = lights.front();
  scene.other_lights.assign(lights.begin() + 1, lights.end());
}

bool has_user_object(const TomlTable& table) {
  const std::vector<TomlTable> objects = table.tables("object");
  return std::ranges::any_of(
      objects, [](const TomlTable& object) { return object.text("shape") == "user"; });
}

}  // namespace

Scene load_scene(const std::string& name_or_file, const SceneOptions& options,
                 std::vector<std::string>* notes) {
  const Source source = find_source(name_or_file);
  const toml::table root = parse_toml(source.text, source.place);
  const TomlTable table(root, source.place);
  Scene scene;
  scene.name = source.name;
  scene.place = source.place;
  if (!source.file.empty()) scene.files.push_back(source.file);
  scene.description = table.text("description");
  set_size(scene, table, options);
  const TomlTable camera_table = table.table("camera");
  const double width_by_height = static_cast<double>(scene.width) / scene.height;
  set_frame(scene, read_camera(camera_table, width_by_height), options.frame, camera_table.place());
  set_lights(scene, table, source.file.parent_path(), options);
  const ObjectContext context{{source.file.parent_path(), options.mesh, &scene.files},
                              options.repair,
                              notes,
                              options.field_side};
  for (const TomlTable& object : table.tables("object")) {
    std::ranges::move(read_objects(object, context), std::back_inserter(scene.objects));
  }
  table.reject_unknown();
  if (options.mesh && !has_user_object(table)) {
    throw InputError("--mesh", scene.name + " has no place for a mesh",
                     "the scene 'mesh', or an object with shape = \"user\"");
  }
  check_scene(scene, source.place);
  return scene;
}

SceneSource scene_source(const std::string& name_or_file) {
  Source found = find_source(name_or_file);
  const toml::table root = parse_toml(found.text, found.place);
  const TomlTable table(root, found.place);
  SceneSource source;
  source.name = found.name;
  if (!found.file.empty()) source.files.push_back(found.file);
  if (table.has("light")) {  // without one, loading the scene will say so
    for (const TomlTable& light : table.one_or_more_tables("light")) {
      std::ranges::move(light_textures(light, found.file.parent_path()),
                        std::back_inserter(source.files));
    }
  }
  for (const TomlTable& object : table.tables("object")) {
    source.has_field |= object.has("field");
    for (const char* key : {"file", "font"}) {
      if (object.has(key)) source.files.push_back(found.file.parent_path() / object.text(key));
    }
  }
  std::tie(source.width, source.height) = read_size(table, source.width, source.height);
  source.frames = frame_count(read_camera(table.table("camera"), 1.0).keys);
  source.text = std::move(found.text);
  return source;
}

std::vector<SceneInfo> built_in_scenes() {
  std::vector<SceneInfo> infos;
  for (const BuiltInFile& file : built_in_files()) {
    const toml::table root = parse_toml(file.text, std::string(file.name));
    const TomlTable table(root, std::string(file.name));
    infos.push_back({std::string(file.name), table.text("description"),
                     frame_count(read_camera(table.table("camera"), 1.0).keys)});
  }
  return infos;
}

}  // namespace wedgesim::functional
