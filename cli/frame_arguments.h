#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "functional/methods/frame.h"

namespace wedgesim::cli {

/// The arguments that say what trace is made of a scene, the same for every command that makes one.
struct FrameArguments {
  std::string file, kind = "coverage", depth = "unorm24", length = "auto";

  void add_to(CLI::App& app);
  /// \throws InputError for anything wrong with them
  functional::FrameOptions options() const;
};

}  // namespace wedgesim::cli
