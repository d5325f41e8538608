#include "functional/scene/triangulate.h"

#include <algorithm>
#include <optional>

namespace wedgesim::functional {
namespace {

using Contour = std::vector<std::uint32_t>;

/// Twice the area of a triangle, positive if it is counter-clockwise.
std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool on_segment(GridPoint a, GridPoint b, GridPoint p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// Whether two segments meet elsewhere than at an end that they share.
bool crosses(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const auto meets = [](GridPoint p, GridPoint q, GridPoint r) {
    return r != p && r != q && on_segment(p, q, r);
  };
  if (meets(a, b, c) || meets(a, b, d) || meets(c, d, a) || meets(c, d, b)) {
    return true;
  }
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

/// Whether `p` lies strictly inside the corner at `at` of a counter-clockwise polygon.
bool inside_corner(GridPoint before, GridPoint at, GridPoint after, GridPoint p) {
  if (turn(before, at, after) >= 0) {
    return turn(before, at, p) > 0 && turn(at, after, p) > 0;
  }
  return !(turn(at, after, p) <= 0 && turn(before, at, p) <= 0);
}

bool is_blocked(const std::vector<GridPoint>& points, const Contour& contour, GridPoint a,
                GridPoint b) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    if (crosses(a, b, points[contour[i]], points[contour[(i + 1) % contour.size()]])) {
      return true;
    }
  }
  return false;
}

/// The place in `outline` nearest to `from` that a bridge can reach.
std::optional<std::size_t> find_bridge(const std::vector<GridPoint>& points, const Contour& outline,
                                       const std::vector<Contour>& holes, GridPoint from) {
  std::optional<std::size_t> best;
  std::int64_t best_distance = 0;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint at = points[outline[i]];
    const GridPoint way = at - from;
    const std::int64_t distance = way.x * way.x + way.y * way.y;
    if ((best && distance >= best_distance) ||
        !inside_corner(points[outline[(i + n - 1) % n]], at, points[outline[(i + 1) % n]], from) ||
        is_blocked(points, outline, from, at) ||
        std::ranges::any_of(
            holes, [&](const Contour& hole) { return is_blocked(points, hole, from, at); })) {
      continue;
    }
    best = i;
    best_distance = distance;
  }
  return best;
}

/// One outline that walks to each hole, round it and back.
std::optional<Contour> bridged(const std::vector<GridPoint>& points,
                               const std::vector<Contour>& contours) {
  Contour outline = contours.front();
  const std::vector<Contour> all_holes(contours.begin() + 1, contours.end());
  std::vector<Contour> holes = all_holes;
  const auto right_end = [&](const Contour& hole) {
    return std::ranges::max_element(
        hole, {}, [&](std::uint32_t i) { return std::pair(points[i].x, points[i].y); });
  };
  std::ranges::sort(holes, std::greater{}, [&](const Contour& hole) {
    const GridPoint end = points[*right_end(hole)];
    return std::pair(end.x, end.y);
  });
  for (Contour& hole : holes) {
    const std::ptrdiff_t offset = right_end(hole) - hole.cbegin();
    std::rotate(hole.begin(), hole.begin() + offset, hole.end());
    const auto place = find_bridge(points, outline, all_holes, points[hole.front()]);
    if (!place) {
      return std::nullopt;
    }
    Contour detour = hole;
    detour.push_back(hole.front());
    detour.push_back(outline[*place]);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(*place) + 1, detour.begin(),
                   detour.end());
  }
  return outline;
}

bool is_ear(const std::vector<GridPoint>& points, const Contour& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const GridPoint a = points[outline[(i + n - 1) % n]];
  const GridPoint b = points[outline[i]];
  const GridPoint c = points[outline[(i + 1) % n]];
  if (turn(a, b, c) <= 0) {
    return false;
  }
  return std::ranges::none_of(outline, [&](std::uint32_t index) {
    const GridPoint p = points[index];
    return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
           turn(c, a, p) >= 0;
  });
}

}  // namespace

std::int64_t doubled_area(const std::vector<GridPoint>& points, const Contour& contour) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const GridPoint a = points[contour[i]];
    const GridPoint b = points[contour[(i + 1) % contour.size()]];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<GridPoint>& points,
                                                      const std::vector<Contour>& contours) {
  std::int64_t area_left = 0;
  for (const Contour& contour : contours) {
    area_left += doubled_area(points, contour);
  }
  std::optional<Contour> outline = bridged(points, contours);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t i = 0;
  std::size_t tried = 0;
  while (outline && outline->size() >= 3) {
    const std::size_t n = outline->size();
    if (tried == n) {
      return {};  // no ear: the contours cross themselves or each other
    }
    i %= n;
    if (!is_ear(points, *outline, i)) {
      ++i;
      ++tried;
      continue;
    }
    const std::array<std::uint32_t, 3> ear{(*outline)[(i + n - 1) % n], (*outline)[i],
                                           (*outline)[(i + 1) % n]};
    triangles.push_back(ear);
    area_left -= turn(points[ear[0]], points[ear[1]], points[ear[2]]);
    outline->erase(outline->begin() + static_cast<std::ptrdiff_t>(i));
    tried = 0;
    ++i;  // the next corner but one: long fans make slivers
  }
  return area_left == 0 ? triangles : std::vector<std::array<std::uint32_t, 3>>{};
}

}  // namespace wedgesim::functional
