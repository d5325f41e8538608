#include "functional/methods/import.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <span>

#include "base/file.h"
#include "cli/command.h"
#include "cli/frame_arguments.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "traces/dump.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

using functional::DepthMeaning;

struct Arguments {
  SceneArguments scene;
  FrameArguments frame;
  std::string image, meaning = "window", channel, tolerance = "0.005";
  bool flip = false;
};

functional::ImportOptions import_options(const Arguments& arguments) {
  functional::ImportOptions options;
  options.meaning = parse_choice<DepthMeaning>("--meaning", arguments.meaning,
                                               std::span(functional::kDepthMeanings));
  options.channel = arguments.channel;
  options.flip = arguments.flip;
  options.tolerance = parse_number("--tolerance", arguments.tolerance, 1e-9, 0.5);
  options.frame = arguments.frame.options();
  return options;
}

std::string fit_text(const functional::Import& import) {
  const functional::DepthFit& fit = import.fit;
  std::string text = fmt::format(
      "fit: of {} pixels inside the casters {} agree, {} are hidden, {} show what lies behind; "
      "{} pixels of sky\n",
      fit.meshes, fit.agree, fit.hidden, fit.behind, import.sky);
  if (2 * fit.agree < fit.meshes || fit.meshes == 0) {
    text +=
        "Less than half of the casters is seen: is it the right frame, and the right meaning?\n";
  }
  if (20 * fit.outline_behind > fit.outline) {
    text += fmt::format(
        "At the casters' outline {} of {} pixels show what lies behind: is the camera right?\n",
        fit.outline_behind, fit.outline);
  }
  return text;
}

int run(const Arguments& arguments) {
  const functional::ImportOptions options = import_options(arguments);
  const std::string& file = arguments.frame.file;
  require_not_read(file, std::array{std::filesystem::path(arguments.image)});
  Progress progress;
  progress.show("reading " + arguments.scene.scene);
  const functional::Scene scene = arguments.scene.load(file);
  traces::require_room(scene.place, scene.width, scene.height);
  const Image image = read_image(arguments.image);
  progress.show("importing " + arguments.image);
  functional::Import import = functional::import_frame(scene, image, options, arguments.image);
  import.frame.trace.header.checksum = traces::write_trace(file, import.frame.trace);
  print(traces::summary(import.frame.trace.view()) + fit_text(import));
  return 0;
}

}  // namespace

Command add_import(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "import", "Make a trace of another renderer's frame: depth image, camera, light, casters");
  auto arguments = std::make_shared<Arguments>();
  arguments->scene.add_to(*app);
  arguments->frame.add_to(*app);
  app->add_option("--depth-image", arguments->image, "Depth of the frame: EXR, PNG, ...")
      ->required()
      ->type_name("FILE");
  app->add_option("--meaning", arguments->meaning,
                  "Of its values: window (0 near, 1 far), reversed, ndc (-1 to 1), view (distance "
                  "along the view direction), distance (from the eye)")
      ->type_name("WORD")
      ->capture_default_str();
  app->add_option("--channel", arguments->channel, "Of the image; the only one, or Z, without it")
      ->type_name("NAME");
  app->add_flag("--flip", arguments->flip, "Its rows come from below");
  app->add_option("--tolerance", arguments->tolerance,
                  "How far depth and meshes may differ, a part of the distance")
      ->type_name("PART")
      ->capture_default_str();
  app->footer(
      "SCENE gives camera, light and casters; other objects are optional.\n"
      "Example:\n  wedgesim import frame.toml --depth-image frame.exr --meaning view -o "
      "frame.wtrace");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
