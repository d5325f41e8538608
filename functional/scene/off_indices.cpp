#include "functional/scene/off_indices.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

// The next line that says something, without its comment; false at the end.
bool next_line(std::istream& file, std::istringstream& line) {
  for (std::string text; std::getline(file, text);) {
    text.erase(std::min(text.find('#'), text.size()));
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    line.clear();
    line.str(text);
    return true;
  }
  return false;
}

// Vertices and faces; they stand behind the format's name, or on the next line.
bool read_counts(std::istream& file, std::uint64_t& vertices, std::uint64_t& faces) {
  std::istringstream line;
  std::string word;
  if (!next_line(file, line) || !(line >> word)) return false;
  if (!word.ends_with("OFF")) line.seekg(0);  // the name may be missing
  if (line >> vertices >> faces) return true;
  return next_line(file, line) && line >> vertices >> faces;
}

}  // namespace

void refuse_index(const std::string& place, std::uint64_t face, std::int64_t index,
                  std::uint64_t vertices) {
  throw InputError(place, fmt::format("face {}: index {}", face, index),
                   vertices == 0 ? "vertices" : fmt::format("0..{}", vertices - 1));
}

void check_off_indices(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::istringstream line;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  if (!read_counts(file, vertices, faces)) return;
  for (std::uint64_t i = 0; i < vertices; ++i) {
    if (!next_line(file, line)) return;
  }
  for (std::uint64_t face = 0; face < faces && next_line(file, line); ++face) {
    std::uint64_t corners = 0;
    line >> corners;
    std::int64_t index = 0;
    for (std::uint64_t i = 0; i < corners && line >> index; ++i) {
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
        refuse_index(path.string(), face, index, vertices);
      }
    }
  }
}

}  // namespace wedgesim::functional
