#include "reports/map_files.h"

namespace wedgesim::reports {

std::vector<std::filesystem::path> map_files(const std::string& prefix) {
  std::vector<std::filesystem::path> files;
  for (const char* map : {"_z_reads", "_li_writes", "_li", "_difference"}) {
    for (const char* kind : {".png", ".exr"}) files.emplace_back(prefix + map + kind);
  }
  return files;
}

}  // namespace wedgesim::reports
