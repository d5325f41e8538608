#pragma once

#include <span>
#include <string_view>

namespace wedgesim::functional {

/// A scene file of traces/scenes/, compiled in so that the program works anywhere.
struct BuiltInFile {
  std::string_view name;  // the file's stem
  std::string_view text;
};

/// All of them, by name.
std::span<const BuiltInFile> built_in_files();

}  // namespace wedgesim::functional
