#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/temporaries.h"
#include "cli/command.h"
#include "cli/print.h"

namespace wedgesim::cli {
namespace {

constexpr int kCheckFailed = 1;
constexpr int kBadInput = 2;

void allow_extras(const Command& command) {
  command.app->allow_extras();
  for (const Command& inner : command.commands) allow_extras(inner);
}

std::vector<Command> add_commands(CLI::App& program) {
  std::vector<Command> commands;
  for (const auto add :
       {add_scenes, add_render, add_trace, add_import, add_dump, add_count, add_cycles, add_explain,
        add_study, add_accuracy, add_stress, add_merge, add_compare}) {
    commands.push_back(add(program));
  }
  // What CLI11 does not know is left over, so that one place can say what would be known.
  program.allow_extras();
  for (const Command& command : commands) allow_extras(command);
  return commands;
}

// The command that the arguments name, as the user would type it.
std::string name_of(const CLI::App& app) {
  return (app.get_parent() == nullptr ? "" : name_of(*app.get_parent()) + " ") + app.get_name();
}

std::string names_of(const CLI::App& app) {
  std::string names;
  const auto add = [&names](const std::string& name) {
    names += (names.empty() ? "" : ", ") + name;
  };
  for (const CLI::App* command : app.get_subcommands({})) add(command->get_name());
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) add(option->get_name());
  }
  return names;
}

void reject_unknown(const CLI::App& app) {
  const std::vector<std::string> unknown = app.remaining();
  if (unknown.empty()) return;
  const std::string place = fmt::format("{}: {}", name_of(app), unknown.front());
  if (unknown.front().starts_with('-')) {
    throw InputError(place, "no such option", "one of " + names_of(app));
  }
  if (app.get_parent() == nullptr) {
    throw InputError(place, "no such command", "one of " + names_of(app));
  }
  throw InputError(place, "one argument too many", "what --help lists");
}

void reject_empty(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) throw InputError(option->get_name(), "is empty", "a value");
    }
  }
}

// Runs the command that was named, or one of its own; nothing if none of them was.
std::optional<int> run_named(const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    reject_unknown(*command.app);
    reject_empty(*command.app);
    const std::optional<int> code = run_named(command.commands);
    return code ? code : command.run();
  }
  return {};
}

int run(CLI::App& program, int argc, char** argv) {
  const std::vector<Command> commands = add_commands(program);
  program.parse(argc, argv);
  reject_unknown(program);
  if (const std::optional<int> code = run_named(commands)) {
    finish_printing();
    return *code;
  }
  throw InputError("wedgesim", "no command given", "one of " + names_of(program));
}

// One line in the form of an InputError for what CLI11 refuses.
std::string message_of(const CLI::ParseError& error, const CLI::App& program) {
  const CLI::App* named = &program;
  while (!named->get_subcommands().empty()) named = named->get_subcommands().front();
  const std::string command = name_of(*named);
  std::string problem = error.what();
  std::string_view expected = "what --help lists";
  if (error.get_name() == "RequiredError") {
    expected = "it among the arguments";
  } else if (error.get_name() == "ArgumentMismatch") {
    problem = problem.substr(0, problem.find(':')) + ": without a value, or more than once";
    expected = "one value";
  } else if (error.get_name() == "ConversionError") {  // all options are texts: a flag has a value
    problem = problem.substr(problem.find(": ") + 2) + ": it takes no value";
    expected = "the option alone";
  }
  return InputError(command, problem, expected).what();
}

int report(int code, std::string_view message) {
  print_note(message);
  return code;
}

// Runs the command and tells in one line what went wrong.
int run_reporting(int argc, char** argv) {
  CLI::App program("Simulates a GPU block that rasterizes penumbra wedges", "wedgesim");
  program.footer("Example:\n  wedgesim study paper2\nwedgesim COMMAND --help says more.");
  try {
    try {
      return run(program, argc, argv);
    } catch (const CLI::Success& wish) {  // --help
      const int code = program.exit(wish);
      finish_printing();
      return code;
    }
  } catch (const CLI::ParseError& error) {
    return report(kBadInput, message_of(error, program));
  } catch (const InputError& error) {
    return report(kBadInput, error.what());
  } catch (const std::bad_alloc&) {
    return report(kBadInput, "memory: not enough for this; expected a smaller frame");
  } catch (const SimulationError& error) {
    return report(kCheckFailed, error.what());
  } catch (const std::exception& error) {
    return report(kCheckFailed, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace
}  // namespace wedgesim::cli

int main(int argc, char** argv) {
  try {
    wedgesim::remove_temporaries_on_signal();
    return wedgesim::cli::run_reporting(argc, argv);
  } catch (...) {  // what cannot even be told
    std::fputs("internal error\n", stderr);
    return wedgesim::cli::kCheckFailed;
  }
}
