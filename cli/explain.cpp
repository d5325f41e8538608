#include "model/count/explain.h"

#include <memory>

#include "cli/command.h"
#include "cli/count_arguments.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "reports/explain_check.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  CountArguments count;
  std::string file, pixel;
};

int run(const Arguments& arguments) {
  const model::CountConfig config = arguments.count.single_config();
  const auto [x, y] = parse_point("--pixel", arguments.pixel);
  const traces::TraceFile trace(arguments.file);
  const model::Explanation explanation = model::explain(trace.view(), x, y, config);
  print(model::to_text(explanation));
  return reports::held(trace.view(), explanation) ? 0 : 1;
}

}  // namespace

Command add_explain(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "explain", "List every wedge, test, access and contribution at a pixel");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("FILE", arguments->file, "A trace")->required()->type_name("");
  app->add_option("--pixel", arguments->pixel, "From the top left")->required()->type_name("X,Y");
  arguments->count.mode = "single-pass";  // one configuration is explained
  arguments->count.add_to(*app);
  app->footer("Example:\n  wedgesim explain columns.wtrace --pixel 438,219");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
