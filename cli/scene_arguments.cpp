#include "cli/scene_arguments.h"

#include <limits>

#include "base/file.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "functional/scene/lights.h"

namespace wedgesim::cli {

void SceneArguments::add_to(CLI::App& app) {
  app.add_option("SCENE", scene, "A built-in scene (wedgesim scenes) or a scene file (.toml)")
      ->required()
      ->type_name("");
  add_options_to(app);
}

void SceneArguments::add_options_to(CLI::App& app) {
  app.add_option("--size", size, "Pixels; the scene's own without it")->type_name("WxH");
  app.add_option("--frame", frame, "Frame of the camera's path")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--mesh", mesh, "A mesh file in the place of the scene's user object")
      ->type_name("FILE");
  app.add_flag("--repair", repair, "Repair casters that are not closed, and say how");
  app.add_option("--light", light, "Turn the light into this shape")->type_name("rect|sphere");
}

functional::Scene SceneArguments::load(const std::filesystem::path& output) const {
  functional::SceneOptions options;
  if (!size.empty()) options.size = parse_size("--size", size);
  options.frame = parse_integer("--frame", frame, 0, std::numeric_limits<int>::max());
  if (!mesh.empty()) options.mesh = mesh;
  options.repair = repair;
  if (!light.empty()) {
    options.light_shape = parse_choice<functional::LightShape>(
        "--light", light,
        {{"rect", functional::LightShape::rectangle}, {"sphere", functional::LightShape::sphere}});
  }
  std::vector<std::string> notes;
  functional::Scene loaded = functional::load_scene(scene, options, &notes);
  for (const std::string& note : notes) print_note(note);
  require_not_read(output, loaded.files);
  return loaded;
}

void LightNumber::add_to(CLI::App& app, const std::string& otherwise) {
  app.add_option("--light-number", text,
                 "Of several lights the one with this number, from 1; without it " + otherwise)
      ->type_name("N");
}

functional::Scene LightNumber::choose(const functional::Scene& scene) const {
  const auto count = static_cast<int>(functional::light_count(scene));
  const int number = text.empty() ? 1 : parse_integer("--light-number", text, 1, count);
  return functional::with_light(scene, static_cast<std::size_t>(number - 1));
}

}  // namespace wedgesim::cli
