#pragma once

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace wedgesim::tests {

/// WEDGESIM_UPDATE_GOLDEN=1: write what the golden tests compare with instead of comparing.
inline bool updates_golden() {
  const char* text = std::getenv("WEDGESIM_UPDATE_GOLDEN");
  return text != nullptr && std::string_view(text) == "1";
}

inline std::filesystem::path golden_folder() { return WEDGESIM_SOURCE_DIR "/tests/golden"; }

/// The bunny comes from a package that may be missing.
inline bool can_load(std::string_view scene) {
  return scene != "bunny" || std::filesystem::exists("/usr/share/glmark2/models/bunny.obj");
}

}  // namespace wedgesim::tests
