#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/print.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::cli {
namespace {

int run() {
  const auto scenes = functional::built_in_scenes();
  std::size_t width = 0;
  for (const auto& scene : scenes) width = std::max(width, scene.name.size());
  for (const auto& scene : scenes) {
    print(fmt::format("{:<{}}  {} ({} frame{})\n", scene.name, width, scene.description,
                      scene.frames, scene.frames == 1 ? "" : "s"));
  }
  return 0;
}

}  // namespace

Command add_scenes(CLI::App& program) {
  CLI::App* app = program.add_subcommand("scenes", "List the built-in scenes, one line each");
  app->footer("Example:\n  wedgesim scenes");
  return {app, run};
}

}  // namespace wedgesim::cli
