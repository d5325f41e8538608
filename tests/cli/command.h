#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/base/temporary_folder.h"

namespace wedgesim::cli {

/// What a run of the command did.
struct Outcome {
  std::string command;  // as a user would type it
  int code = -1;        // 128 + signal if it was killed
  std::string out, err;
};

/// Runs build/.../cli/wedgesim with these arguments and waits for it.
Outcome run_command(const std::vector<std::string>& arguments);

/// The same with standard error on a terminal; `err` is what the terminal was sent.
Outcome run_on_terminal(const std::vector<std::string>& arguments);

/// The same with standard output into this file.
Outcome run_into(const std::filesystem::path& out, const std::vector<std::string>& arguments);

/// Runs it with TMPDIR `folder`, sends it `signal` as soon as there is something in that folder,
/// and waits for it.
Outcome interrupt_command(const std::filesystem::path& folder, int signal,
                          const std::vector<std::string>& arguments);

/// Runs it and sends it `signal` after some time, if it has not ended by itself; waits for it.
Outcome kill_command(unsigned milliseconds, int signal, const std::vector<std::string>& arguments);

/// Exit code 2, nothing on standard output, exactly one line on standard error that holds all of
/// `words`.
void expect_bad_input(const Outcome& outcome, const std::vector<std::string>& words);

/// Exit code 0 and nothing on standard error.
void expect_good(const Outcome& outcome);

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// A small trace of a built-in scene, made by the command.
std::filesystem::path make_trace(const TemporaryFolder& folder,
                                 const std::string& scene = "plain-columns",
                                 const std::vector<std::string>& options = {});

}  // namespace wedgesim::cli
