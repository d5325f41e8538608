#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "model/count/config.h"

namespace wedgesim::cli {

/// The options that describe what is counted, the same for every command that walks a trace.
struct CountArguments {
  std::string mode = "single-pass,three-pass", tile = "8", cull = "both", umbra_cull = "zmax",
              accept = "none", share = "eye", z = "auto", tile_build = "eager";

  void add_to(CLI::App& app);
  /// Every combination of the sets.
  /// \throws InputError naming the option
  std::vector<model::CountConfig> configs() const;
  /// \throws InputError also if there are several, naming an option that has several values
  model::CountConfig single_config() const;
};

}  // namespace wedgesim::cli
