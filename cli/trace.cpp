#include <memory>

#include "cli/command.h"
#include "cli/frame_arguments.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "functional/methods/frame.h"
#include "traces/dump.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  SceneArguments scene;
  FrameArguments frame;
  LightNumber light_number;
};

int run(const Arguments& arguments) {
  const functional::FrameOptions options = arguments.frame.options();
  Progress progress;
  progress.show("reading " + arguments.scene.scene);
  const functional::Scene scene =
      arguments.light_number.choose(arguments.scene.load(arguments.frame.file));
  if (scene.light.texture) {
    print_note("the trace has the light without its texture: the block knows even lights alone");
  }
  traces::require_room(scene.place, scene.width, scene.height);
  progress.show("rendering " + scene.name);
  functional::Frame frame = functional::make_frame(scene, options);
  progress.show("writing " + arguments.frame.file);
  frame.trace.header.checksum = traces::write_trace(arguments.frame.file, frame.trace);
  print(traces::summary(frame.trace.view()));
  return 0;
}

}  // namespace

Command add_trace(CLI::App& program) {
  CLI::App* app = program.add_subcommand("trace", "Render a scene into a trace file");
  auto arguments = std::make_shared<Arguments>();
  arguments->scene.add_to(*app);
  arguments->light_number.add_to(*app, "the first: a trace has one light");
  arguments->frame.add_to(*app);
  app->footer("Example:\n  wedgesim trace columns -o columns.wtrace --light sphere");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
