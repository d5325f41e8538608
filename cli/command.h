#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace wedgesim::cli {

/// A subcommand: what CLI11 parses for it, and what it does then.
struct Command {
  CLI::App* app = nullptr;
  /// \return the exit code: 0 if every check held, 1 if one failed
  /// \throws InputError for bad input
  std::function<int()> run;
  std::vector<Command> commands{};  // of its own; one of them runs in its place if it is named
};

Command add_scenes(CLI::App& program);
Command add_render(CLI::App& program);
Command add_trace(CLI::App& program);
Command add_import(CLI::App& program);
Command add_dump(CLI::App& program);
Command add_count(CLI::App& program);
Command add_cycles(CLI::App& program);
Command add_explain(CLI::App& program);
Command add_accuracy(CLI::App& program);
Command add_stress(CLI::App& program);
Command add_study(CLI::App& program);
/// Under `study` as well as by themselves.
Command add_merge(CLI::App& parent);
Command add_compare(CLI::App& parent);
Command add_report(CLI::App& parent);

}  // namespace wedgesim::cli
