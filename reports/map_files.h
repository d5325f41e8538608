#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wedgesim::reports {

/// The files that write_maps (maps.h) may write.
std::vector<std::filesystem::path> map_files(const std::string& prefix);

}  // namespace wedgesim::reports
