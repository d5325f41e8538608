#include "traces/dump.h"

#include <array>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "cli/command.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string file, obj;
};

int run(const Arguments& arguments) {
  const traces::TraceFile trace(arguments.file);
  if (arguments.obj.empty()) {
    traces::dump_json(std::cout, trace.view());
    return 0;
  }
  require_not_read(arguments.obj, std::array{std::filesystem::path(arguments.file)});
  write_stream(arguments.obj, [&](std::ostream& out) { traces::dump_obj(out, trace.view()); });
  return 0;
}

}  // namespace

Command add_dump(CLI::App& program) {
  CLI::App* app = program.add_subcommand("dump", "Print all of a trace as JSON");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("FILE", arguments->file, "A trace")->required()->type_name("");
  app->add_option("--obj", arguments->obj, "Write its wedges as an OBJ mesh instead")
      ->type_name("OBJ");
  app->footer(
      "Examples:\n  wedgesim dump columns.wtrace | jq '.wedges | length'\n"
      "  wedgesim dump columns.wtrace --obj wedges.obj");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
