#include "functional/methods/screen_sides.h"

#include <algorithm>
#include <cmath>

#include "functional/geometry/hull.h"

namespace wedgesim::functional {

ScreenSide ScreenSides::bare_side(const SidedPlane& plane) const {
  ScreenSide side;
  side.plane = window_plane(window_, plane.plane);
  side.minus = plane.minus;
  side.y_begin = window_.height;
  return side;
}

void ScreenSides::add_umbra(std::span<const glm::dvec3> outline, const SidedPlane& plane,
                            traces::fb::UmbraRole role, bool twisted,
                            std::vector<ScreenSide>& sides) const {
  const std::vector<WindowPoint> points = clip_to_window(window_, outline);
  if (points.empty()) return;
  const auto [near, far] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  const std::size_t first = sides.size();
  std::int64_t largest = 0;
  for (std::vector<SnappedPoint>& part : convex_parts(snap(points))) {
    const std::int64_t area = doubled_area(part);
    if (area == 0) continue;
    ScreenSide side = bare_side(plane);
    side.umbra.role = role;
    side.umbra.eye_facing = area < 0;
    side.umbra.z_min = near->z;
    side.umbra.z_max = far->z;
    const double inward = side.minus ? -side.plane.z : side.plane.z;
    if (twisted && (area < 0 ? inward < 0.0 : inward > 0.0)) side.minus = !side.minus;
    const auto [low, high] = std::minmax_element(
        part.begin(), part.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    side.y_begin = std::max(0, (low->y - 128) >> 8);
    side.y_end = std::min(window_.height, ((high->y - 128) >> 8) + 1);
    side.umbra.outline = std::move(part);
    if (std::abs(area) > largest) {
      largest = std::abs(area);
      sides.insert(sides.begin() + static_cast<std::ptrdiff_t>(first), std::move(side));
    } else {
      sides.push_back(std::move(side));
    }
  }
}

ScreenWedge* ScreenSides::add_wedge(const WorldWedge& volume, const SidedPlane& plane,
                                    std::size_t first, std::vector<ScreenSide>& sides) const {
  std::vector<glm::dvec2> points;
  std::vector<glm::dvec3> corners;
  for (const WedgeFace& face : volume.faces) {
    corners.clear();
    for (const std::uint32_t c : face.corners) corners.push_back(volume.vertices[c]);
    add_points(corners, points);
  }
  std::vector<glm::dvec2> hull = convex_hull(points);
  if (hull.empty()) return nullptr;
  if (sides.size() == first) sides.push_back(bare_side(plane));
  ScreenSide& side = sides[first];
  const auto [low, high] = std::minmax_element(
      hull.begin(), hull.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  side.y_begin = std::min(side.y_begin, std::max(0, static_cast<int>(std::floor(low->y)) - 1));
  side.y_end =
      std::max(side.y_end, std::min(window_.height, static_cast<int>(std::ceil(high->y)) + 1));
  side.wedge.hull = std::move(hull);
  side.wedge.planes.reserve(volume.planes.size());
  for (const glm::dvec4& p : volume.planes) side.wedge.planes.push_back(window_plane(window_, p));
  return &side.wedge;
}

void ScreenSides::add_points(std::span<const glm::dvec3> polygon,
                             std::vector<glm::dvec2>& points) const {
  for (const WindowPoint& p : clip_to_window(window_, polygon)) points.emplace_back(p);
}

void ScreenSides::split_wedge(const WorldWedge& volume, const SidedPlane& plane,
                              ScreenWedge& wedge) const {
  const glm::dvec4 inward = plane.minus ? -plane.plane : plane.plane;
  wedge.in_halves = true;
  for (std::size_t half = 0; half < 2; ++half) {
    std::vector<glm::dvec2> points;
    for (const auto& face : faces_inside(volume, half == 1 ? inward : -inward)) {
      add_points(face, points);
    }
    wedge.half_hulls[half] = convex_hull(points);
  }
}

void set_group(std::vector<ScreenSide>& sides, std::size_t first, std::uint32_t group) {
  for (; first < sides.size(); ++first) sides[first].group = group;
}

}  // namespace wedgesim::functional
