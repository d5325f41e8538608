#include "functional/scene/glyph.h"

#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::functional {
namespace {

constexpr double kGridPerUnit = 64.0;

GridPoint to_grid(glm::dvec2 p) {
  return {std::llround(kGridPerUnit * p.x), std::llround(kGridPerUnit * p.y)};
}

glm::dvec2 to_point(const FT_Vector* v) {
  return {static_cast<double>(v->x), static_cast<double>(v->y)};
}

/// Collects an outline's pieces as straight lines.
struct Pen {
  std::vector<std::vector<GridPoint>> contours;
  glm::dvec2 at{0.0};
  int segments = 1;

  void line(glm::dvec2 to) {
    contours.back().push_back(to_grid(to));
    at = to;
  }
  void cubic(glm::dvec2 a, glm::dvec2 b, glm::dvec2 to) {
    const glm::dvec2 from = at;
    for (int i = 1; i <= segments; ++i) {
      const double t = static_cast<double>(i) / segments;
      const double s = 1.0 - t;
      line(s * s * s * from + 3.0 * s * s * t * a + 3.0 * s * t * t * b + t * t * t * to);
    }
  }
  void conic(glm::dvec2 control, glm::dvec2 to) {
    cubic(at + 2.0 / 3.0 * (control - at), to + 2.0 / 3.0 * (control - to), to);
  }
};

int move_to(const FT_Vector* to, void* pen) {
  static_cast<Pen*>(pen)->contours.emplace_back();
  static_cast<Pen*>(pen)->line(to_point(to));
  return 0;
}
int line_to(const FT_Vector* to, void* pen) {
  static_cast<Pen*>(pen)->line(to_point(to));
  return 0;
}
int conic_to(const FT_Vector* control, const FT_Vector* to, void* pen) {
  static_cast<Pen*>(pen)->conic(to_point(control), to_point(to));
  return 0;
}
int cubic_to(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* pen) {
  static_cast<Pen*>(pen)->cubic(to_point(a), to_point(b), to_point(to));
  return 0;
}

/// Without points that turn no corner; empty if fewer than three are left.
std::vector<GridPoint> simplified(std::vector<GridPoint> contour) {
  for (std::size_t i = 0; i < contour.size() && contour.size() >= 3;) {
    const std::size_t n = contour.size();
    const GridPoint in = contour[i] - contour[(i + n - 1) % n];
    const GridPoint out = contour[(i + 1) % n] - contour[i];
    if (in.x * out.y == in.y * out.x) {
      contour.erase(contour.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 1 ? i - 2 : 0;  // its neighbours may now turn no corner either
    } else {
      ++i;
    }
  }
  return contour.size() >= 3 ? contour : std::vector<GridPoint>{};
}

}  // namespace

struct Font::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Library() { CHECK_EQ(FT_Init_FreeType(&library), 0); }
  ~Library() { FT_Done_FreeType(library); }  // its faces too
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

Font::Font(const std::filesystem::path& path) : library_(std::make_unique<Library>()), path_(path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    throw InputError(path.string(), "is not a regular file", "a font file");
  }
  if (FT_New_Face(library_->library, path.c_str(), 0, &library_->face) != 0 ||
      !FT_IS_SCALABLE(library_->face)) {
    throw InputError(path.string(), "cannot be read as a font", "a TrueType font");
  }
}

Font::~Font() = default;

Glyph Font::glyph(char character, int curve_segments) const {
  FT_Face face = library_->face;
  const FT_UInt index = FT_Get_Char_Index(face, static_cast<unsigned char>(character));
  if (index == 0 || FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) {
    throw InputError(path_.string(), fmt::format("the font has no '{}'", character),
                     "a character of the font");
  }
  const FT_Outline_Funcs functions{move_to, line_to, conic_to, cubic_to, 0, 0};
  Pen pen;
  pen.segments = curve_segments;
  CHECK_EQ(FT_Outline_Decompose(&face->glyph->outline, &functions, &pen), 0);
  // TrueType fills to the right of an outline, PostScript to the left; ours is left.
  const bool turn = FT_Outline_Get_Orientation(&face->glyph->outline) == FT_ORIENTATION_TRUETYPE;
  Glyph glyph;
  glyph.advance = std::llround(kGridPerUnit * static_cast<double>(face->glyph->advance.x));
  for (const std::vector<GridPoint>& drawn : pen.contours) {
    std::vector<GridPoint> contour = simplified(drawn);
    if (turn) {
      std::ranges::reverse(contour);
    }
    if (!contour.empty()) {
      glyph.contours.push_back(std::move(contour));
    }
  }
  return glyph;
}

}  // namespace wedgesim::functional
