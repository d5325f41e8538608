#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "functional/scene/triangulate.h"

namespace wedgesim::functional {

/// One letter as straight lines on a grid of 1/64 font unit. Contours are closed, without repeated
/// or collinear neighbours; outsides run counter-clockwise, holes clockwise.
struct Glyph {
  std::vector<std::vector<GridPoint>> contours;
  std::int64_t advance = 0;  // to the next letter, grid units
};

/// A TrueType or PostScript font, read by FreeType.
class Font {
 public:
  /// \throws InputError if the file is missing or is not a scalable font
  explicit Font(const std::filesystem::path& path);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// \param curve_segments  straight pieces for one curve, at least 1
  /// \throws InputError if the font has no such character
  Glyph glyph(char character, int curve_segments) const;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::filesystem::path path_;
};

}  // namespace wedgesim::functional
