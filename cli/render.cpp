#include "functional/methods/render.h"

#include <fmt/format.h>

#include <memory>

#include "base/image.h"
#include "cli/command.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "reports/picture.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  SceneArguments scene;
  LightNumber light_number;
  std::string image, method = "coverage", samples = "1024";
  bool visibility = false;
};

int run(const Arguments& arguments) {
  const int samples = parse_integer("--samples", arguments.samples, 1, 1 << 20);
  const functional::MethodChoice method = functional::choose_method(
      "--method",
      arguments.method == "reference" ? fmt::format("raytraced-{}", samples) : arguments.method);
  reports::require_image_name(arguments.image);
  Progress progress;
  progress.show("reading " + arguments.scene.scene);
  functional::Scene scene = arguments.scene.load(arguments.image);
  const bool one_light = arguments.visibility || !arguments.light_number.text.empty();
  if (one_light) scene = arguments.light_number.choose(scene);
  progress.show("rendering " + scene.name);
  const functional::View view = functional::render_view(scene, method);
  if (arguments.visibility) {
    reports::write_values(arguments.image, view.visibility.values, scene.width, scene.height);
  } else {
    reports::write_colours(arguments.image, functional::shade(scene, view));
  }
  return 0;
}

std::string names_of_methods() {
  std::string names = "reference (rays)";
  for (const functional::Method& method : functional::methods()) {
    names += fmt::format(", {}", method.name);
  }
  return names;
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Render a scene into an image");
  auto arguments = std::make_shared<Arguments>();
  arguments->scene.add_to(*app);
  arguments->light_number.add_to(*app, "all (of --visibility the first)");
  app->add_option("-o,--output", arguments->image, "Image to write, .png or .exr")
      ->required()
      ->type_name("IMG");
  app->add_option("--method", arguments->method,
                  "As NAME, NAME-SAMPLES or NAME:KEY=VALUE,…: " + names_of_methods())
      ->type_name("M")
      ->capture_default_str();
  app->add_option("--samples", arguments->samples, "Samples of the light, for the reference")
      ->type_name("N")
      ->capture_default_str();
  app->add_flag("--visibility", arguments->visibility,
                "Write the visible fraction of the light alone; EXR holds it as it is");
  app->footer("Example:\n  wedgesim render plain-columns -o plain.png --size 320x213 --frame 5");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
