#include "cli/frame_arguments.h"

#include "base/toml_table.h"
#include "cli/parse.h"

namespace wedgesim::cli {

namespace fb = traces::fb;

void FrameArguments::add_to(CLI::App& app) {
  app.add_option("-o,--output", file, "Trace to write, .wtrace")->required()->type_name("FILE");
  app.add_option("--kind", kind, "Of the penumbra wedges")
      ->type_name("coverage|linear")
      ->capture_default_str();
  app.add_option("--depth", depth, "Stored depth: unorm24, float32, unorm16, float32_reversed")
      ->type_name("FORMAT")
      ->capture_default_str();
  app.add_option("--length", length,
                 "Of the shadow volumes, world units; auto: just beyond the receivers")
      ->type_name("auto|UNITS")
      ->capture_default_str();
}

functional::FrameOptions FrameArguments::options() const {
  functional::FrameOptions options;
  options.kind = parse_choice<fb::WedgeKind>(
      "--kind", kind, {{"coverage", fb::WedgeKind_coverage}, {"linear", fb::WedgeKind_linear}});
  options.depth_format =
      parse_choice<fb::DepthFormat>("--depth", depth,
                                    {{"unorm24", fb::DepthFormat_unorm24},
                                     {"float32", fb::DepthFormat_float32},
                                     {"unorm16", fb::DepthFormat_unorm16},
                                     {"float32_reversed", fb::DepthFormat_float32_reversed}});
  if (length != "auto") {
    constexpr auto kSize = Range::size();
    options.length = parse_number("--length", length, kSize.low, kSize.high);
  }
  return options;
}

}  // namespace wedgesim::cli
