#include <memory>

#include "base/toml_table.h"
#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "functional/methods/frame.h"
#include "traces/dump.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

namespace fb = traces::fb;

struct Arguments {
  SceneArguments scene;
  std::string file, kind = "coverage", depth = "unorm24", length = "auto";
};

functional::FrameOptions frame_options(const Arguments& arguments) {
  functional::FrameOptions options;
  options.kind = parse_choice<fb::WedgeKind>(
      "--kind", arguments.kind,
      {{"coverage", fb::WedgeKind_coverage}, {"linear", fb::WedgeKind_linear}});
  options.depth_format =
      parse_choice<fb::DepthFormat>("--depth", arguments.depth,
                                    {{"unorm24", fb::DepthFormat_unorm24},
                                     {"float32", fb::DepthFormat_float32},
                                     {"unorm16", fb::DepthFormat_unorm16},
                                     {"float32_reversed", fb::DepthFormat_float32_reversed}});
  if (arguments.length != "auto") {
    constexpr auto kSize = Range::size();
    options.length = parse_number("--length", arguments.length, kSize.low, kSize.high);
  }
  return options;
}

int run(const Arguments& arguments) {
  const functional::FrameOptions options = frame_options(arguments);
  Progress progress;
  progress.show("reading " + arguments.scene.scene);
  const functional::Scene scene = arguments.scene.load(arguments.file);
  traces::require_room(scene.place, scene.width, scene.height);
  progress.show("rendering " + scene.name);
  functional::Frame frame = functional::make_frame(scene, options);
  progress.show("writing " + arguments.file);
  frame.trace.header.checksum = traces::write_trace(arguments.file, frame.trace);
  print(traces::summary(frame.trace.view()));
  return 0;
}

}  // namespace

Command add_trace(CLI::App& program) {
  CLI::App* app = program.add_subcommand("trace", "Render a scene into a trace file");
  auto arguments = std::make_shared<Arguments>();
  arguments->scene.add_to(*app);
  app->add_option("-o,--output", arguments->file, "Trace to write, .wtrace")
      ->required()
      ->type_name("FILE");
  app->add_option("--kind", arguments->kind, "Of the penumbra wedges")
      ->type_name("coverage|linear")
      ->capture_default_str();
  app->add_option("--depth", arguments->depth,
                  "Stored depth: unorm24, float32, unorm16, float32_reversed")
      ->type_name("FORMAT")
      ->capture_default_str();
  app->add_option("--length", arguments->length,
                  "Of the shadow volumes, world units; auto: just beyond the receivers")
      ->type_name("auto|UNITS")
      ->capture_default_str();
  app->footer("Example:\n  wedgesim trace columns -o columns.wtrace --light sphere");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
