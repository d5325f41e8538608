#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace wedgesim::cli {

/// A subcommand: what CLI11 parses for it, and what it does then.
struct Command {
  CLI::App* app = nullptr;
  /// \return the exit code: 0 if every check held, 1 if one failed
  /// \throws InputError for bad input
  std::function<int()> run;
};

Command add_scenes(CLI::App& program);
Command add_render(CLI::App& program);
Command add_trace(CLI::App& program);
Command add_import(CLI::App& program);
Command add_dump(CLI::App& program);
Command add_count(CLI::App& program);
Command add_cycles(CLI::App& program);
Command add_explain(CLI::App& program);
Command add_study(CLI::App& program);

}  // namespace wedgesim::cli
