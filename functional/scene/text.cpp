#include "functional/scene/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "functional/scene/glyph.h"
#include "functional/scene/triangulate.h"

namespace wedgesim::functional {
namespace {

/// One outside contour with its holes.
using Contours = std::vector<std::vector<std::uint32_t>>;

/// All letters' contours side by side.
struct Outline {
  std::vector<GridPoint> points;
  std::vector<std::vector<std::uint32_t>> contours;
};

Outline lay_out(const std::string& text, const TextStyle& style) {
  const Font font(style.font);
  Outline outline;
  GridPoint at{0, 0};
  for (const char character : text) {
    if (character < ' ' || character > '~') {
      throw InputError("text", "has a character that is not printable ASCII",
                       "characters from space to ~");
    }
    const Glyph glyph = font.glyph(character, style.curve_segments);
    for (const std::vector<GridPoint>& contour : glyph.contours) {
      std::vector<std::uint32_t>& indices = outline.contours.emplace_back(contour.size());
      std::iota(indices.begin(), indices.end(), static_cast<std::uint32_t>(outline.points.size()));
      for (const GridPoint& p : contour) {
        outline.points.push_back(at + p);
      }
    }
    at.x += glyph.advance;
  }
  return outline;
}

/// Whether a point is inside a contour, by crossings of the ray to the right; exact.
bool contains(const Outline& outline, const std::vector<std::uint32_t>& contour, GridPoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    GridPoint a = outline.points[contour[i]];
    GridPoint b = outline.points[contour[(i + 1) % contour.size()]];
    if ((a.y > p.y) == (b.y > p.y)) {
      continue;
    }
    if (a.y > b.y) {
      std::swap(a, b);
    }
    inside ^= (b.x - a.x) * (p.y - a.y) > (p.x - a.x) * (b.y - a.y);
  }
  return inside;
}

/// Gives each hole to the smallest outside contour round it.
std::vector<Contours> grouped(const Outline& outline) {
  std::vector<Contours> groups;
  for (const auto& contour : outline.contours) {
    if (doubled_area(outline.points, contour) > 0) {
      groups.push_back({contour});
    }
  }
  for (const auto& contour : outline.contours) {
    if (doubled_area(outline.points, contour) > 0) {
      continue;
    }
    Contours* owner = nullptr;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (Contours& group : groups) {
      const std::int64_t area = doubled_area(outline.points, group.front());
      if (area < least && contains(outline, group.front(), outline.points[contour.front()])) {
        owner = &group;
        least = area;
      }
    }
    if (owner == nullptr) {
      throw InputError("text", "the font has a hole outside every outline", "another font");
    }
    owner->push_back(contour);
  }
  return groups;
}

/// Front and back vertices, the front ones first, scaled to the style.
std::vector<glm::dvec3> extruded_positions(const std::vector<GridPoint>& points,
                                           const TextStyle& style) {
  const auto [left, right] =
      std::ranges::minmax(points, {}, [](const GridPoint& p) { return p.x; });
  const auto [bottom, top] =
      std::ranges::minmax(points, {}, [](const GridPoint& p) { return p.y; });
  const double scale = style.height / static_cast<double>(top.y - bottom.y);
  const double middle = 0.5 * static_cast<double>(left.x + right.x);
  std::vector<glm::dvec3> positions;
  for (const double z : {0.5 * style.depth, -0.5 * style.depth}) {
    for (const GridPoint& p : points) {
      positions.emplace_back(scale * (static_cast<double>(p.x) - middle),
                             scale * static_cast<double>(p.y - bottom.y), z);
    }
  }
  return positions;
}

void extrude(const Outline& outline, const Contours& contours, Mesh& mesh) {
  const auto back = static_cast<std::uint32_t>(outline.points.size());
  const auto cap = triangulate(outline.points, contours);
  if (cap.empty()) {
    throw InputError("text", "a letter's outline crosses itself", "another font");
  }
  for (const auto& t : cap) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({back + t[0], back + t[2], back + t[1]});
  }
  for (const auto& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t i = contour[k];
      const std::uint32_t j = contour[(k + 1) % contour.size()];
      mesh.triangles.push_back({i, back + i, back + j});
      mesh.triangles.push_back({i, back + j, j});
    }
  }
}

}  // namespace

std::filesystem::path default_font() {
  return "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
}

Mesh make_text(const std::string& text, const TextStyle& style) {
  const Outline outline = lay_out(text, style);
  if (outline.points.empty()) {
    throw InputError("text", fmt::format("'{}' has no outline", text), "letters or digits");
  }
  Mesh mesh;
  mesh.positions = extruded_positions(outline.points, style);
  for (const Contours& contours : grouped(outline)) {
    extrude(outline, contours, mesh);
  }
  return mesh;
}

}  // namespace wedgesim::functional
